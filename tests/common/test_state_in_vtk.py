"""Every state of a file must read back the same in VTK, value for value."""

import subprocess

import numpy as np
import pytest

vtk = pytest.importorskip("vtk", minversion="9.3")
from vtk.util.numpy_support import vtk_to_numpy  # noqa: E402

# The empty state is the last: VTK 9.4 and newer look for the cells of a step behind those of all filled steps before it and
# so miss the entry of an empty one. The particles of a run are never lost, so that this order does not arise.
COUNTS = [3, 1, 250, 250, 0]


def read_step(path, step):
    reader = vtk.vtkHDFReader()
    reader.SetFileName(str(path))
    reader.UpdateInformation()
    reader.SetStep(step)
    reader.Update()
    return reader.GetNumberOfSteps(), reader.GetOutputDataObject(0)


def array(data, name):
    return vtk_to_numpy(data.GetPointData().GetArray(name))


@pytest.fixture(scope="module")
def trajectory(tmp_path_factory, build):
    path = tmp_path_factory.mktemp("states") / "sample.vtkhdf"
    subprocess.run([build / "tests/common/write_sample_states", path, *map(str, COUNTS)], check=True)
    return path


@pytest.mark.parametrize("step", range(len(COUNTS)))
def test_vtk_reads_every_step(trajectory, step):
    steps, data = read_step(trajectory, step)
    assert steps == len(COUNTS)
    count = COUNTS[step]
    assert data.GetNumberOfPoints() == count
    assert data.GetNumberOfVerts() == count
    assert data.GetNumberOfCells() == count
    if count == 0:
        return
    a = np.arange(count) + 1e3 * step
    points = vtk_to_numpy(data.GetPoints().GetData())
    assert points.dtype == np.float64
    np.testing.assert_array_equal(points, np.stack([1e-6 * a, -2e-6 * a, 1 / (a + 1)], axis=1))
    np.testing.assert_array_equal(array(data, "Radius"), 25e-6 / (a + 1))
    np.testing.assert_array_equal(array(data, "Velocity"), np.stack([a, a * a, -a / 3], axis=1))
    np.testing.assert_array_equal(array(data, "AngularVelocity"), np.stack([-a, 0 * a + 0.5, a / 7], axis=1))
    np.testing.assert_array_equal(array(data, "Id"), np.arange(count))
    np.testing.assert_array_equal(array(data, "CoordinationNumber"), np.arange(count) % 7)
    field = data.GetFieldData()
    assert vtk_to_numpy(field.GetArray("Time")) == [0.25 * step]
    assert vtk_to_numpy(field.GetArray("Step")) == [1000 * step]
    assert [data.GetVerts().GetCellSize(i) for i in range(count)] == [1] * count


def test_times_are_those_of_the_states(trajectory):
    reader = vtk.vtkHDFReader()
    reader.SetFileName(str(trajectory))
    reader.UpdateInformation()
    key = vtk.vtkStreamingDemandDrivenPipeline.TIME_STEPS()
    assert list(reader.GetOutputInformation(0).Get(key)) == [0.25 * s for s in range(len(COUNTS))]
