"""Random particles through `convert` from every format to every other: the same bits come back."""

import json
import sys
from itertools import permutations
from pathlib import Path

import h5py
import numpy as np
import pytest
import vtk
from vtk.util.numpy_support import vtk_to_numpy

sys.path.insert(0, str(Path(__file__).parent))
import small_layers

ENDINGS = ("csv", "vtp", "dump", "vtkhdf", "xyz")
COLUMNS = ["id", "x", "y", "z", "radius", "vx", "vy", "vz", "omegax", "omegay", "omegaz"]


def random_particles(seed, count=300):
    """Numbers of every size and of every length, zeros and the largest among them."""
    generator = np.random.default_rng(seed)
    magnitude = 10.0 ** generator.integers(-12, 6, (count, 10))
    values = generator.normal(0, 1, (count, 10)) * magnitude
    values[generator.random(values.shape) < 0.02] = 0
    values[0, :3] = [5e-324, -1.7976931348623157e308 / 4, 1e308]
    values[:, 3] = np.abs(values[:, 3]) + 1e-12
    ids = generator.permutation(np.concatenate([[2**53, -7], 1 + generator.permutation(10**6)[: count - 2]]))
    return ids.astype(int), values


def write_csv(path, ids, values):
    lines = [",".join([str(i), *map(repr, row)]) for i, row in zip(ids.tolist(), values.tolist())]
    path.write_text(",".join(COLUMNS) + "\n" + "\n".join(lines) + "\n")


def read_csv(path, names=COLUMNS):
    head, *lines = path.read_text().splitlines()
    places = [head.split(",").index(name) for name in names]
    return np.array([[float(line.split(",")[p]) for p in places] for line in lines])


@pytest.mark.parametrize("seed", range(3))
def test_every_format_after_every_other(good, tmp_path, seed):
    ids, values = random_particles(seed)
    write_csv(tmp_path / "start.csv", ids, values)
    expected = np.column_stack([ids, values])
    for first, second in permutations(ENDINGS, 2):
        good("convert", "start.csv", f"a.{first}")
        good("convert", f"a.{first}", f"b.{second}")
        good("convert", f"b.{second}", "end.csv")
        assert np.array_equal(read_csv(tmp_path / "end.csv"), expected), (first, second)


@pytest.mark.parametrize("ending", ENDINGS)
@pytest.mark.parametrize("name", [*small_layers.texts(), "vtkhdf"])
def test_every_foreign_format(good, tmp_path, name, ending):
    """Against the numbers that went into the files, not against the program's own tables."""
    if name == "vtkhdf":
        small_layers.write_vtkhdf(tmp_path / "layer")
    else:
        (tmp_path / "layer").write_text(small_layers.texts()[name])
    good("convert", "layer", f"a.{ending}")
    good("convert", f"a.{ending}", "end.csv")
    points, radii, velocity, ids = small_layers.particles()
    assert np.array_equal(read_csv(tmp_path / "end.csv", ["x", "y", "z", "radius"]), np.column_stack([points, radii]))
    if name in ("lammps-dump", "mercury-data", "extended-xyz", "vtkhdf"):
        assert np.array_equal(read_csv(tmp_path / "end.csv", ["vx", "vy", "vz"]), velocity)
    if name not in ("mercury-data",):
        assert np.array_equal(read_csv(tmp_path / "end.csv", ["id"])[:, 0], ids)


@pytest.mark.parametrize("block", [512, 2048])
def test_hdf5_behind_a_block_of_the_user(good, tmp_path, block):
    """As programs put before it that keep notes there."""
    small_layers.write_vtkhdf(tmp_path / "layer", userblock_size=block)
    good("convert", "layer", "end.csv")
    assert np.array_equal(read_csv(tmp_path / "end.csv", ["x", "y", "z"]), small_layers.particles()[0])


@pytest.mark.parametrize("form", ["xs ys zs", "xu yu zu", "xsu ysu zsu", "xs y zu"])
def test_scaled_and_unwrapped_coordinates(good, tmp_path, form):
    """In any image of the box along the periodic y, and scaled by the box where the name says so."""
    points, radii, _, ids = small_layers.particles()
    low, high = np.array(small_layers.BOX).T
    points = points + np.outer(np.arange(len(ids)) % 3 - 1, [0, 1, 0]) * (high - low) * ("yu" in form or "ysu" in form)
    written = np.where(["s" in name for name in form.split()], (points - low) / (high - low), points)
    lines = "".join(f"{i} {x!r} {y!r} {z!r} {r!r}\n" for i, (x, y, z), r in zip(ids.tolist(), written.tolist(), radii.tolist()))
    head = small_layers.dump_head().split("ITEM: ATOMS")[0]
    (tmp_path / "layer").write_text(f"{head}ITEM: ATOMS id {form} radius\n{lines}")
    good("convert", "layer", "a.dump")
    good("convert", "a.dump", "end.csv")
    assert read_csv(tmp_path / "end.csv", ["x", "y", "z"]) == pytest.approx(points, rel=1e-13, abs=1e-18)


def steps_of(good, file):
    return [json.loads(good("describe", file, "--json", "--step", number)) for number in ("100", "250", "900")]


@pytest.fixture
def run(tmp_path):
    """A dump of three steps with times, types and another number of particles in each, and what went into it."""
    generator = np.random.default_rng(4)
    text, steps = "", []
    for number, count in ((100, 5), (250, 0), (900, 8)):
        values = generator.uniform(1e-4, 9e-4, (count, 10))
        ids, types = generator.integers(1, 10**12, count), generator.integers(1, 4, count)
        rows = "".join(f"{i} {t} {' '.join(map(repr, row))}\n" for i, t, row in zip(ids, types, values.tolist()))
        text += f"ITEM: TIME\n{number * 1e-7!r}\nITEM: TIMESTEP\n{number}\nITEM: NUMBER OF ATOMS\n{count}\n"
        text += "ITEM: BOX BOUNDS ff pp ff\n-0.1 0.3\n-0.7 0.1\n0 1e-3\n"
        text += f"ITEM: ATOMS id type {' '.join(COLUMNS[1:])}\n{rows}"
        steps.append((number, ids, types, values))
    (tmp_path / "run.dump").write_text(text)
    return steps


@pytest.mark.parametrize("ending", ["dump", "vtkhdf", "xyz"])
def test_every_step_in_every_format_that_holds_several(analyze, good, tmp_path, run, ending):
    done = analyze("convert", "run.dump", f"all.{ending}", "--step", "all")
    assert done.returncode == 0, done.stderr
    facts = steps_of(good, f"all.{ending}")
    assert [f["particles"] for f in facts] == [5, 0, 8]
    if ending != "vtkhdf":
        assert done.stderr == ""
        # Extended XYZ has sides instead of upper bounds, and no side leads from -0.7 to 0.1 to the last bit.
        rounding = 0 if ending == "dump" else 2e-16
        assert all(f["box y [m]"] == pytest.approx([-0.7, 0.1], rel=0, abs=rounding) for f in facts)
        assert all(f["periodic"] == "y" for f in facts)
    else:
        assert "the format vtkhdf has no place for the box (but for its period along y); left out" in done.stderr
        assert all((f["y_min [m]"], f["y_period [m]"]) == (-0.7, 0.1 + 0.7) for f in facts)
        assert [float(f["time [s]"]) for f in facts] == pytest.approx([1e-5, 2.5e-5, 9e-5])
    for number, ids, types, values in run:
        good("convert", f"all.{ending}", "end.csv", "--step", number)
        if len(ids) == 0:
            continue
        assert np.array_equal(read_csv(tmp_path / "end.csv"), np.column_stack([ids, values])), number
        assert np.array_equal(read_csv(tmp_path / "end.csv", ["type"])[:, 0], types)
    one = tmp_path / f"one.{ending}"
    good("convert", f"all.{ending}", one, "--step", "all")
    assert one.read_bytes() == (tmp_path / f"all.{ending}").read_bytes() or ending == "vtkhdf"


@pytest.mark.parametrize("ending", ["csv", "vtp"])
def test_formats_of_one_step(refused, analyze, good, run, ending):
    assert f"all.{ending}: a file of the format {ending} holds one time step" in refused("convert", "run.dump", f"all.{ending}", "--step", "all")
    done = analyze("convert", "run.dump", f"last.{ending}")
    assert f"the format {ending} has no place for the box, the number of the time step, the time; left out" in done.stderr


def test_what_is_not_said_stays_unsaid(good, tmp_path):
    """No velocities become zeros or nan on the way, no identities are lost."""
    points, radii, _, ids = small_layers.particles()
    (tmp_path / "layer").write_text("x,y,z,r\n" + small_layers.rows("{x},{y},{z},{r}"))
    for ending in ENDINGS:
        good("convert", "layer", f"a.{ending}")
        good("convert", f"a.{ending}", "end.csv")
        names = (tmp_path / "end.csv").read_text().splitlines()[0]
        assert "vx" not in names and "omega" not in names, ending
    with h5py.File(tmp_path / "a.vtkhdf") as file:
        assert sorted(file["VTKHDF/PointData"]) == ["Id", "Radius"]


def test_a_step_that_says_other_things(analyze, tmp_path):
    """A state file has the same arrays in all steps."""
    head = small_layers.dump_head()
    with_velocities = head + small_layers.rows("{id} 1 {x} {y} {z} {r} {vx} {vy} {vz}")
    without = head.replace("\n7\n", "\n8\n", 1).replace(" vx vy vz", "") + small_layers.rows("{id} 1 {x} {y} {z} {r}")
    (tmp_path / "layer").write_text(with_velocities + without)
    done = analyze("convert", "layer", "out.vtkhdf", "--step", "all")
    assert done.returncode == 2
    assert "out.vtkhdf: the time step 8 says other things of its particles" in done.stderr.splitlines()[-1]
    assert [file.name for file in tmp_path.iterdir()] == ["layer"]


@pytest.mark.parametrize("ending", ["vtp", "vtkhdf"])
def test_vtk_reads_what_is_written(good, tmp_path, ending):
    (tmp_path / "layer").write_text(small_layers.texts()["lammps-dump"])
    good("convert", "layer", f"a.{ending}")
    reader = {"vtp": vtk.vtkXMLPolyDataReader, "vtkhdf": vtk.vtkHDFReader}[ending]()
    reader.SetFileName(str(tmp_path / f"a.{ending}"))
    reader.Update()
    data = reader.GetOutput().GetPointData()
    points, radii, velocity, ids = small_layers.particles()
    assert np.array_equal(vtk_to_numpy(reader.GetOutput().GetPoints().GetData()), points)
    assert np.array_equal(vtk_to_numpy(data.GetArray("Radius")), radii)
    assert np.array_equal(vtk_to_numpy(data.GetArray("Velocity")), velocity)
    assert np.array_equal(vtk_to_numpy(data.GetArray("Id")), ids)
    if ending == "vtp":  # what OVITO reads: base64 in the elements, nothing appended
        text = (tmp_path / "a.vtp").read_text()
        assert "appended" not in text.lower() and 'format="binary"' in text
