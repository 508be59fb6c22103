"""Animations show the chosen states of a trajectory, in order."""

import h5py
import numpy
import pytest
from animation import animate, chosen_steps
from PIL import Image
from states import read_walls

DIAMETER, COUNT = 5e-5, 20


def trajectory(path, steps):
    """Particles on the base that all move on along x by a diameter from one state to the next."""
    with h5py.File(path, "w") as file:
        root, offsets = file.create_group("VTKHDF"), numpy.arange(steps) * COUNT
        places = numpy.arange(COUNT) * DIAMETER
        points = numpy.zeros((steps, COUNT, 3))
        points[:, :, 0] = places + DIAMETER * numpy.arange(steps)[:, None]
        points[:, :, 2] = DIAMETER / 2
        root["Points"] = points.reshape(-1, 3)
        root["NumberOfPoints"] = numpy.full(steps, COUNT)
        root["Steps/Values"] = 1e-3 * numpy.arange(steps)
        root["Steps/PointOffsets"] = offsets
        for name, values in (("Radius", numpy.full(steps * COUNT, DIAMETER / 2)), ("Velocity", numpy.full((steps * COUNT, 3), 0.05))):
            root[f"PointData/{name}"] = values
            root[f"Steps/PointDataOffsets/{name}"] = offsets
        file.create_group("recoat").attrs["diameter"] = DIAMETER


def wall_file(path, steps):
    """Base (0), a gate (4) that is gone after the first step, and a blade (3) that moves on by a diameter from step to step."""
    base = [[-5, 0, 0], [-5, 9, 0], [90, 9, 0], [90, 0, 0]]
    gate = [[20, 0, 0], [20, 9, 0], [20, 9, 6], [20, 0, 6]]
    blade = numpy.array([[0, 0, 1.5], [4, 0, 1.5], [4, 0, 9], [0, 0, 9]])
    polygons = [[(0, base), (3, blade + [number, 0, 0])] + [(4, gate)] * (number == 0) for number in range(steps)]
    cells = numpy.array([len(walls) for walls in polygons])
    before = numpy.cumsum(cells) - cells
    with h5py.File(path, "w") as file:
        root = file.create_group("VTKHDF")
        root["Points"] = DIAMETER * numpy.concatenate([corners for walls in polygons for _, corners in walls])
        root["NumberOfPoints"] = 4 * cells
        root["CellData/Wall"] = [wall for walls in polygons for wall, _ in walls]
        root["Polygons/NumberOfCells"] = cells
        root["Polygons/Offsets"] = numpy.concatenate([4 * numpy.arange(count + 1) for count in cells])
        root["Polygons/Connectivity"] = numpy.concatenate([numpy.arange(4 * count) for count in cells])
        for name, values in (("CellOffsets", before), ("ConnectivityIdOffsets", 4 * before)):
            root[f"Steps/{name}"] = values[:, None] * [0, 0, 1, 0]
        root["Steps/PointOffsets"], root["Steps/CellDataOffsets/Wall"] = 4 * before, before
        root["Steps/Values"] = 1e-3 * numpy.arange(steps)


def test_walls_are_those_of_the_moment(tmp_path):
    wall_file(tmp_path / "walls.vtkhdf", 3)
    for time, walls, blade in ((0.0, [0, 3, 4], 0), (0.9e-3, [0, 3, 4], 0), (1e-3, [0, 3], 1), (0.5, [0, 3], 2)):
        found = read_walls(tmp_path / "walls.vtkhdf", time)
        assert [number for number, _ in found] == walls
        assert found[1][1][:, 0] / DIAMETER == pytest.approx(numpy.array([0, 4, 4, 0]) + blade)


def test_every_state_is_a_frame_of_its_own(tmp_path):
    trajectory(tmp_path / "trajectory.vtkhdf", 3)
    wall_file(tmp_path / "walls.vtkhdf", 3)
    animate(tmp_path / "trajectory.vtkhdf", tmp_path / "walls.vtkhdf", tmp_path / "run.gif")
    with Image.open(tmp_path / "run.gif") as picture:
        assert picture.n_frames == 3
        frames = []
        for number in range(3):
            picture.seek(number)
            frames.append(numpy.array(picture.convert("RGB")))
    assert all((one != other).any() for one, other in zip(frames, frames[1:]))


def test_long_runs_are_thinned_evenly():
    steps = chosen_steps(1000)
    assert (len(steps), steps[0], steps[-1]) == (120, 0, 999)
    assert set(numpy.diff(steps)) <= {8, 9}
    assert list(chosen_steps(3)) == [0, 1, 2]
