"""Random particles through `convert` from every format to every other: the same bits come back."""

import sys
from itertools import permutations
from pathlib import Path

import numpy as np
import pytest

sys.path.insert(0, str(Path(__file__).parent))
import small_layers

ENDINGS = ("csv", "vtp", "dump", "vtkhdf")
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
    if name in ("lammps-dump", "mercury-data", "vtkhdf"):
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
