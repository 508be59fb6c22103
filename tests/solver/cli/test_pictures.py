"""What Python and VTK see of a run: its trajectory, also while it goes on, and its walls."""

import re
import signal
import subprocess
import time

import h5py
import numpy as np
import pytest
import vtk

DIAMETER = 50e-6
WALLS = ("base", "rear", "front", "blade", "gate")


@pytest.fixture(scope="module")
def states(root):
    """The reader of docs/schema.md, as it stands there."""
    code = re.search(r"```python\n(.*?)```", (root / "docs/schema.md").read_text(), re.DOTALL).group(1)
    names = {}
    exec(code, names)
    return names["states"]


def test_trajectory_of_a_run_that_goes_on_was_stopped_and_ended(solver, states):
    out = solver.folder / "out"
    run = ("run", "spread.yaml", "--out", "out", "--threads", "1", "--quiet")
    process = subprocess.Popen([solver.program, *run], cwd=solver.folder)
    deadline = time.monotonic() + 60
    while len(list(states(out))) < 2 and process.poll() is None and time.monotonic() < deadline:
        time.sleep(0.005)
    running = list(states(out))
    process.send_signal(signal.SIGINT)
    assert process.wait(timeout=60) in (0, 130)
    stopped = list(states(out))
    solver.good(*run)
    ended = list(states(out))
    assert (out / "trajectory.vtkhdf").exists()
    assert 2 <= len(running) <= len(stopped) <= len(ended)
    assert [time for time, *_ in ended] == pytest.approx(2e-3 * np.arange(len(ended)))
    for partial in (running, stopped):
        for state, same in zip(partial, ended):
            assert state[0] == same[0]
            assert np.array_equal(state[1], same[1]) and np.array_equal(state[2], same[2])
    assert all(points.shape == velocity.shape == (40, 3) for _, points, velocity in ended)


def shown(path, moment):
    """What VTK, and so ParaView, makes of a file at a time."""
    reader = vtk.vtkHDFReader()
    reader.SetFileName(str(path))
    reader.UpdateInformation()
    reader.UpdateTimeStep(moment)
    data = reader.GetOutputDataObject(0)
    assert data.GetClassName() == "vtkPolyData"
    return data


def bounds(walls, name):
    """Bounds [d_p] of one wall; None where it is not there."""
    number, numbers = WALLS.index(name), walls.GetCellData().GetArray("Wall")
    cells = [k for k in range(walls.GetNumberOfCells()) if numbers.GetValue(k) == number]
    if not cells:
        return None
    corners = np.array([walls.GetPoint(p) for k in cells for p in points_of(walls, k)]) / DIAMETER
    return corners.min(axis=0), corners.max(axis=0)


def points_of(walls, cell):
    found = walls.GetCell(cell)
    return [found.GetPointId(k) for k in range(found.GetNumberOfPoints())]


def test_walls_move_with_the_particles(solver):
    solver.good("run", "spread.yaml", "--out", "out", "--threads", "1", "--quiet")
    out, stages = solver.folder / "out", solver.summary("out")["stages"]
    ends = np.cumsum([stage["time"] for stage in stages])
    filled, spread = shown(out / "walls.vtkhdf", ends[0]), shown(out / "walls.vtkhdf", ends[2])
    for walls in (filled, spread):
        lower, upper = bounds(walls, "base")
        assert lower == pytest.approx([-5, 0, 0], abs=1e-9) and upper == pytest.approx([25, 4, 0], abs=1e-9)
    assert bounds(filled, "gate")[0][0] == pytest.approx(8) and bounds(spread, "gate") is None
    assert bounds(filled, "blade")[0] == pytest.approx([0, 0, 0])
    assert bounds(spread, "blade")[0] == pytest.approx([6, 0, 1.5], abs=1e-9)
    assert bounds(spread, "blade")[1][:2] == pytest.approx([10, 4])
    top = np.array([shown(out / "spread.vtkhdf", ends[2]).GetPoint(k) for k in range(40)]).max() / DIAMETER
    assert bounds(spread, "blade")[1][2] > 3 and top > 0
    middle = shown(out / "walls.vtkhdf", ends[1] + 0.9 * stages[2]["time"])
    assert 1 < bounds(middle, "blade")[0][0] <= 6


def pixels(*shapes):
    """A small picture of polygons and points, drawn off screen."""
    renderer, window = vtk.vtkRenderer(), vtk.vtkRenderWindow()
    window.SetOffScreenRendering(1)
    window.SetSize(120, 60)
    window.AddRenderer(renderer)
    for shape in shapes:
        mapper, actor = vtk.vtkPolyDataMapper(), vtk.vtkActor()
        mapper.SetInputData(shape)
        mapper.ScalarVisibilityOff()
        actor.SetMapper(mapper)
        renderer.AddActor(actor)
    renderer.GetActiveCamera().SetPosition(-1, -2, 1)
    renderer.GetActiveCamera().SetViewUp(0, 0, 1)
    renderer.ResetCamera()
    window.Render()
    image = vtk.vtkWindowToImageFilter()
    image.SetInput(window)
    image.Update()
    values = image.GetOutput().GetPointData().GetScalars()
    return np.array([values.GetTuple(k) for k in range(values.GetNumberOfTuples())])


def test_walls_and_particles_are_drawn_together(solver):
    solver.good("run", "spread.yaml", "--out", "out", "--threads", "1", "--quiet")
    out = solver.folder / "out"
    moment = 2e-3
    drawn = pixels(shown(out / "trajectory.vtkhdf", moment), shown(out / "walls.vtkhdf", moment))
    assert 0.05 < (drawn.sum(axis=1) > 0).mean() < 0.95


def test_walls_are_the_same_after_a_restart(solver):
    solver.good("run", "spread.yaml", "--out", "whole", "--threads", "1", "--quiet")
    steps = solver.summary("whole")["steps"]
    for until in (steps // 3, 2 * steps // 3):
        solver("run", "spread.yaml", "--out", "parts", "--threads", "1", "--quiet", "--until-step", until)
    solver.good("resume", "parts", "--threads", "1", "--quiet")
    with h5py.File(solver.folder / "whole/walls.vtkhdf") as whole, h5py.File(solver.folder / "parts/walls.vtkhdf") as parts:
        for name in ("Points", "Steps/Values", "CellData/Wall", "Polygons/Connectivity"):
            assert np.array_equal(whole["VTKHDF"][name], parts["VTKHDF"][name]), name
    assert solver.summary("whole")["stages"][2]["layer_end"] == solver.summary("parts")["stages"][2]["layer_end"]
    assert solver.summary("whole")["stages"][2]["layer_end"] <= 6 * DIAMETER + 1e-12
