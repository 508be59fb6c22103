"""Reading speed of recoat-analyze beside numpy, pandas and vtk on the same files: `reading.py BUILD RESULTS.json`.

Files of a million random particles; CPU seconds (user and system) of one thread, the least of three runs, the start of
the program taken off. `describe` reads, checks and sums up; the others read into arrays.
"""

import json
import os
import subprocess
import sys
import tempfile
import time
from pathlib import Path

import numpy as np
import pandas
import vtk
from vtk.util.numpy_support import numpy_to_vtk, vtk_to_numpy

COUNT = 1_000_000
RUNS = 3


def particles():
    generator = np.random.default_rng(1)
    points = generator.uniform([0, 0, 0], [0.05, 0.01, 2e-4], (COUNT, 3))
    return points, generator.normal(2.5e-5, 2e-6, COUNT), generator.normal(0, 0.1, (COUNT, 3)), generator.permutation(COUNT) + 1


def write_csv(path):
    points, radii, _, ids = particles()
    rows = zip(ids.tolist(), points.tolist(), radii.tolist())
    path.write_text("id,x,y,z,radius\n" + "".join(f"{i},{x!r},{y!r},{z!r},{r!r}\n" for i, (x, y, z), r in rows))


def write_dump(path):
    points, radii, velocity, ids = particles()
    head = f"ITEM: TIMESTEP\n1\nITEM: NUMBER OF ATOMS\n{COUNT}\nITEM: BOX BOUNDS ff pp ff\n0 0.05\n0 0.01\n0 0.001\n"
    rows = zip(ids.tolist(), points.tolist(), velocity.tolist(), radii.tolist())
    lines = ("%d 1 %g %g %g %g %g %g %g\n" % (i, *p, *v, r) for i, p, v, r in rows)
    path.write_text(head + "ITEM: ATOMS id type x y z vx vy vz radius\n" + "".join(lines))


def write_vtp(path, mode, compressor):
    points, radii, velocity, ids = particles()
    data, holder = vtk.vtkPolyData(), vtk.vtkPoints()
    holder.SetData(numpy_to_vtk(points, deep=True))
    data.SetPoints(holder)
    for name, values in (("velocity", velocity), ("id", ids), ("radius", radii)):
        array = numpy_to_vtk(values, deep=True)
        array.SetName(name)
        data.GetPointData().AddArray(array)
    writer = vtk.vtkXMLPolyDataWriter()
    getattr(writer, f"SetDataModeTo{mode}")()
    getattr(writer, f"SetCompressorTypeTo{compressor}")()
    writer.SetInputData(data)
    writer.SetFileName(str(path))
    assert writer.Write() == 1


def with_vtk(path):
    reader = vtk.vtkXMLPolyDataReader()
    reader.SetFileName(str(path))
    reader.Update()
    return vtk_to_numpy(reader.GetOutput().GetPoints().GetData())


FILES = {
    "layer.csv": (write_csv, {
        "numpy.loadtxt": lambda path: np.loadtxt(path, delimiter=",", skiprows=1),
        "pandas.read_csv": pandas.read_csv,
    }),
    "layer.dump": (write_dump, {
        "numpy.loadtxt": lambda path: np.loadtxt(path, skiprows=9),
        "pandas.read_csv": lambda path: pandas.read_csv(path, skiprows=9, sep=" ", header=None),
    }),
    "ascii.vtp": (lambda path: write_vtp(path, "Ascii", "None"), {"vtk": with_vtk}),
    "base64.vtp": (lambda path: write_vtp(path, "Binary", "None"), {"vtk": with_vtk}),
    "zlib.vtp": (lambda path: write_vtp(path, "Appended", "ZLib"), {"vtk": with_vtk}),
}


def seconds_of(call):
    """CPU time of this process."""
    best = float("inf")
    for _ in range(RUNS):
        start = time.process_time()
        call()
        best = min(best, time.process_time() - start)
    return best


def seconds_of_program(*command):
    best = float("inf")
    for _ in range(RUNS):
        before = os.times()
        subprocess.run(command, check=True, stdout=subprocess.DEVNULL)
        after = os.times()
        best = min(best, after.children_user + after.children_system - before.children_user - before.children_system)
    return best


def main(build, results):
    program = str(Path(build) / "analyzer/recoat-analyze")
    start = seconds_of_program(program, "--version")
    table = {}
    with tempfile.TemporaryDirectory() as folder:
        for name, (write, others) in FILES.items():
            path = Path(folder) / name
            write(path)
            megabytes = path.stat().st_size / 1e6
            seconds = {"recoat-analyze describe": seconds_of_program(program, "describe", str(path)) - start}
            seconds |= {other: seconds_of(lambda: read(path)) for other, read in others.items()}
            table[name] = {"MB": megabytes, "particles": COUNT, "cpu_s": seconds, "MB_per_s": {k: megabytes / s for k, s in seconds.items()}}
            print(name, f"{megabytes:.0f} MB:", ", ".join(f"{k} {megabytes / s:.0f} MB/s" for k, s in seconds.items()), flush=True)
            path.unlink()
    versions = {"numpy": np.__version__, "pandas": pandas.__version__, "vtk": vtk.vtkVersion().GetVTKVersion()}
    cpu = next((line.split(":")[1].strip() for line in open("/proc/cpuinfo") if line.startswith("model name")), "")
    Path(results).write_text(json.dumps({"start_s": start, "files": table, "versions": versions, "cpu": cpu}, indent=1) + "\n")


if __name__ == "__main__":
    main(*sys.argv[1:])
