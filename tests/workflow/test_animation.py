"""Animations show the chosen states of a trajectory, in order."""

import h5py
import numpy
from animation import animate, chosen_steps
from PIL import Image

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


def test_every_state_is_a_frame_of_its_own(tmp_path):
    trajectory(tmp_path / "trajectory.vtkhdf", 3)
    animate(tmp_path / "trajectory.vtkhdf", tmp_path / "run.gif")
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
