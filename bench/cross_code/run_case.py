"""Runs one start with one of the codes and measures where the particles came to lie, with recoat-analyze."""

import json
import resource
import subprocess
from pathlib import Path

import yaml
from starts import random_column, write_data, write_table

MARGIN = 2  # d_p by which the box of LAMMPS is larger than the walls and the column


def steps_of(phase, plan):
    return round(phase["duration"] / plan["time_step"])


def scene(plan, case):
    """The case as a scene of recoat-solve."""
    walls = [{"plane": {"name": "base", "normal": [0, 0, 1]}}]
    for name, x, sign in zip(("rear", "front"), case["ends"], (1, -1)):
        walls.append({"plane": {"name": name, "point": [f"{x} dp", "0 m", "0 m"], "normal": [sign, 0, 0]}})
    if "blade" in case:
        lower, upper = ([f"{x} dp", bound, f"{z} dp"] for bound, (x, z) in blade_corners(case))
        walls.append({"box": {"name": "blade", "lower": lower, "upper": upper}})
    stages = []
    for number, phase in enumerate(case["phases"], 1):
        stage = {"name": f"phase{number}", "duration": f"{steps_of(phase, plan) * plan['time_step']!r} s"}
        if "blade_speed" in phase:
            stage |= {"wall": "blade", "velocity": [f"{phase['blade_speed']} m/s", "0 m/s", "0 m/s"]}
        stages.append({"move" if "blade_speed" in phase else "run": stage})
    material = plan["material"]
    units = {"diameter": "m", "density": "kg/m3", "young_modulus": "Pa"}
    return {
        "scene": "particles",
        "particles": "start.csv",
        "time_step": f"{plan['time_step']!r} s",
        "gravity": f"{plan['gravity']} m/s2",
        "y_period": f"{case['width']} dp",
        "material": {key: f"{value!r} {units[key]}" if key in units else value for key, value in material.items()},
        "contact": plan["contact"] | {"rolling_length": "reduced_radius", "rolling_form": "relative"},
        "walls": walls,
        "stages": stages,
    }


def blade_corners(case):
    """Bound along y and (x, z) [d_p] of the blade's lower and upper corner."""
    return [("-inf", case["blade"]["lower"]), ("inf", case["blade"]["upper"])]


def lammps_variables(plan, case):
    """The case as variables of lammps.in."""
    d, material, contact = plan["material"]["diameter"], plan["material"], plan["contact"]
    phases = [steps_of(phase, plan) for phase in case["phases"]] + [0, 0]
    blade = case.get("blade", {"lower": [0, 0], "upper": [0, 0]})
    return {
        "modulus": material["young_modulus"],
        "poisson": material["poisson_ratio"],
        "restitution": contact["restitution"],
        "sliding": contact["sliding_friction"],
        "rolling": contact["rolling_friction"],
        "rolling_stiffness": plan["rolling_spring"]["stiffness"],
        "rolling_damping": plan["rolling_spring"]["damping"],
        "gravity": plan["gravity"],
        "dt": plan["time_step"],
        "left": case["ends"][0] * d,
        "right": case["ends"][1] * d,
        "has_blade": int("blade" in case),
        "rear": blade["lower"][0] * d,
        "front": blade["upper"][0] * d,
        "lower": blade["lower"][1] * d,
        "upper": blade["upper"][1] * d,
        "speed": max(phase.get("blade_speed", 0) for phase in case["phases"]),
        "steps_before": phases[0],
        "steps_moving": phases[1],
        "steps_after": phases[2],
    }


def run_recoat(plan, case, folder, build):
    """The file with the last state."""
    (folder / "scene.yaml").write_text(yaml.safe_dump(scene(plan, case), sort_keys=False))
    command = [f"{build}/solver/recoat-solve", "run", folder / "scene.yaml", "--out", folder / "run", "--overwrite"]
    finish(command + ["--threads", "1", "--backend", "cpu"], folder)
    return folder / f"run/phase{len(case['phases'])}.vtkhdf"


def run_lammps(plan, case, folder, program):
    """The file with the last state."""
    dump = folder / "final.dump"
    variables = lammps_variables(plan, case) | {"data": folder / "start.data", "dump": dump}
    words = [word for name, value in variables.items() for word in ("-var", name, str(value))]
    script = Path(__file__).parent / "lammps.in"
    finish([program, "-in", script, "-log", folder / "log.lammps", *words], folder)
    return dump


def finish(command, folder):
    """Run a program to its end; a RuntimeError with what it said where it fails."""
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    if done.returncode:
        raise RuntimeError(f"{Path(command[0]).name} failed in {folder}: {(done.stderr or done.stdout).strip()[-500:]}")


def measure(plan, case, state, folder, build):
    """Packing density of the region and coordination number of the particles in it."""
    d, region = plan["material"]["diameter"], case["region"]
    configuration = {
        "d_p": d,
        "density": plan["material"]["density"],
        "base": region["base"] * d,
        "h_b": region["h_b"] * d,
        "x_range": [x * d for x in region["x_range"]],
        "y_min": 0.0,
        "y_period": case["width"] * d,
        "voxels_per_dp": [],
        "bootstrap_resamples": 0,
    }
    (folder / "region.json").write_text(json.dumps(configuration))
    command = [f"{build}/analyzer/recoat-analyze", "metrics", state, "--config", folder / "region.json", "--quiet"]
    finish(command + ["--json", folder / "metrics.json"], folder)
    metrics = json.loads((folder / "metrics.json").read_text())
    return {"density": metrics["phi_exact"]["mean"], "coordination_number": metrics["clusters"]["cn_mean"]}


def run_case(plan, name, seed, code, program, folder, build):
    """What one code makes of one start: quantities by name, and the processor time of the code [s]."""
    case, folder = plan["cases"][name], Path(folder).resolve()
    folder.mkdir(parents=True, exist_ok=True)
    d, density = plan["material"]["diameter"], plan["material"]["density"]
    points = d * random_column(case, plan["packing_density"], seed)
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    if code == "recoat":
        write_table(folder / "start.csv", points, d / 2)
        state = run_recoat(plan, case, folder, build)
    else:
        ends = [x * d for x in (case["ends"][0] - MARGIN, case["ends"][1] + MARGIN)]
        top = float(points[:, 2].max()) + MARGIN * d
        write_data(folder / "start.data", points, d / 2, density, ends, case["width"] * d, top)
        state = run_lammps(plan, case, folder, program)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    seconds = after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime
    return measure(plan, case, state, folder, build) | {"seconds": round(seconds, 1)}
