"""Files that name others: pieces of one data set (.pvtu), time steps (.pvd, .vtk.series)."""

import json
import shutil
import sys
from pathlib import Path

import numpy as np
import pytest
import vtk
from vtk.util.numpy_support import numpy_to_vtk

sys.path.insert(0, str(Path(__file__).parent))
import small_layers

REPORTS = Path(__file__).resolve().parents[1] / "data/reports"
PVD = '<?xml version="1.0"?>\n<VTKFile type="Collection" version="0.1">\n<Collection>\n{}</Collection>\n</VTKFile>\n'
ENTRY = '<DataSet timestep="{}" part="{}" file="{}"/>\n'


def described(good, *arguments):
    return json.loads(good("describe", *arguments, "--json"))


@pytest.fixture
def pieces(tmp_path):
    """The files of a run of another code: a collection, a head, and three pieces, one of them empty."""
    for file in [*REPORTS.glob("a05_*"), *REPORTS.glob("out.*")]:
        shutil.copy(file, tmp_path)


def write_layer(path, moved=0.0, ids=True):
    """The small layer as VTP, moved along x."""
    points, radii, _, numbers = small_layers.particles()
    data, holder = vtk.vtkPolyData(), vtk.vtkPoints()
    holder.SetData(numpy_to_vtk(points + [moved, 0, 0], deep=True))
    data.SetPoints(holder)
    for name, values in [("radius", radii)] + [("id", numbers)] * ids:
        array = numpy_to_vtk(values, deep=True)
        array.SetName(name)
        data.GetPointData().AddArray(array)
    writer = vtk.vtkXMLPolyDataWriter()
    writer.SetFileName(str(path))
    writer.SetInputData(data)
    assert writer.Write() == 1


@pytest.mark.parametrize("file", ["a05_out.0000.pvtu", "a05_out.pvd"])
def test_the_pieces_together(good, pieces, tmp_path, file):
    facts = described(good, file)
    assert facts["particles"] == 304 and facts["radius [m]"] == [2.5e-5, 2.5e-5]
    good("convert", file, "all.csv")
    reader = vtk.vtkXMLPUnstructuredGridReader()
    reader.SetFileName(str(tmp_path / "a05_out.0000.pvtu"))
    reader.Update()
    points = np.array([reader.GetOutput().GetPoint(i) for i in range(304)])
    names = (tmp_path / "all.csv").read_text().splitlines()[0].split(",")
    ours = np.loadtxt(tmp_path / "all.csv", delimiter=",", skiprows=1)
    assert np.array_equal(ours[:, [names.index(a) for a in "xyz"]], points)


def test_time_steps_of_a_collection(good, analyze, tmp_path):
    for step in range(3):
        write_layer(tmp_path / f"layer{step}.vtp", moved=1e-3 * step)
    (tmp_path / "run.pvd").write_text(PVD.format("".join(ENTRY.format(t, 0, f"layer{i}.vtp") for i, t in enumerate([0, 0.5, 1.25]))))
    facts = described(good, "run.pvd", "--step", "all")
    assert [(f["step"], f["time"]) for f in facts] == [("0", "0"), ("1", "0.5"), ("2", "1.25")]
    assert np.diff([f["mean x [m]"] for f in facts]) == pytest.approx([1e-3, 1e-3])
    good("convert", "run.pvd", "run.vtkhdf", "--step", "all")
    assert [f["time [s]"] for f in described(good, "run.vtkhdf", "--step", "all")] == ["0", "0.5", "1.25"]
    # The same part again at the same time is the step again, not more particles.
    (tmp_path / "again.pvd").write_text(PVD.format("".join(ENTRY.format(1, 0, f"layer{i}.vtp") for i in (0, 1))))
    done = analyze("describe", "again.pvd", "--json")
    assert json.loads(done.stdout)["particles"] == small_layers.COUNT
    assert "the time 1 is there twice (places 1 and 2 of 2 in the file); taken is the step 1 at place 2" in done.stderr


def test_parts_of_a_step(good, refused, tmp_path):
    write_layer(tmp_path / "a.vtp", ids=False)
    write_layer(tmp_path / "b.vtp", moved=1.0, ids=False)
    (tmp_path / "run.pvd").write_text(PVD.format(ENTRY.format(1, 0, "a.vtp") + ENTRY.format(1, 1, "b.vtp")))
    assert described(good, "run.pvd")["particles"] == 2 * small_layers.COUNT
    write_layer(tmp_path / "b.vtp", moved=1.0)
    sentence = refused("describe", "run.pvd")
    assert "run.pvd:5: the file b.vtp says other things of its particles than those before it" in sentence


def test_a_series_of_files(good, refused, tmp_path):
    (tmp_path / "layer.vtk").write_text(small_layers.legacy())
    (tmp_path / "dump").write_text(small_layers.texts()["lammps-dump"])
    files = [{"name": "layer.vtk", "time": 0.5}, {"name": "dump", "time": 2}]
    series = tmp_path / "layer.vtk.series"
    series.write_text(json.dumps({"file-series-version": "1.0", "files": files}))
    assert described(good, "layer.vtk.series", "--step", "0")["time"] == "0.5"
    last = described(good, "layer.vtk.series")
    assert (last["time"], last["particles"]) == ("2", small_layers.COUNT)
    for text, problem in [
        ('{"file-series-version": "1.0", "files": [', "the file is no whole JSON"),
        ('{"file-series-version": "1.0"}', 'there is no list "files"'),
        ('{"file-series-version": "1.0", "files": [{"time": 0}]}', 'the entry 0 of "files" has no name'),
        ('{"file-series-version": "1.0", "files": []}', "the file names no files of particles"),
    ]:
        series.write_text(text)
        assert problem in refused("describe", "layer.vtk.series")


def test_what_is_wrong_with_named_files(good, refused, pieces, tmp_path):
    (tmp_path / "out.0000.00001.vtu").unlink()
    sentence = refused("describe", "a05_out.pvd")
    assert "out.0000.00001.vtu: the file cannot be read" in sentence and "it is named in a05_out.0000.pvtu:10" in sentence
    (tmp_path / "self.pvd").write_text(PVD.format(ENTRY.format(0, 0, "self.pvd")))
    assert "self.pvd: the file names files itself" in refused("describe", "self.pvd")
    (tmp_path / "two.dump").write_text(2 * small_layers.texts()["lammps-dump"])
    (tmp_path / "run.pvd").write_text(PVD.format(ENTRY.format(0, 0, "two.dump")))
    assert "two.dump: the file holds 2 time steps, but stands for one" in refused("describe", "run.pvd")
    (tmp_path / "run.pvd").write_text(PVD.format(ENTRY.format("soon", 0, "two.dump")))
    assert 'run.pvd:4: the time step "soon" is no number' in refused("describe", "run.pvd")
    (tmp_path / "run.pvd").write_text(PVD.format(""))
    assert "run.pvd: the file names no files of particles" in refused("describe", "run.pvd")


def test_points_of_other_pieces_are_left_out(good, tmp_path):
    """Pieces may repeat points of their neighbours, marked as ghosts."""
    (tmp_path / "layer.vtp").write_text(
        small_layers.xml().replace("<PointData>\n", '<PointData>\n<DataArray type="UInt8" Name="vtkGhostType" format="ascii">\n1 '
                                   + "0 " * (small_layers.COUNT - 1) + "\n</DataArray>\n")
    )
    assert described(good, "layer.vtp")["particles"] == small_layers.COUNT - 1


def test_an_empty_piece(good, tmp_path):
    """A process that has no particles writes a piece without arrays."""
    empty = '<Piece NumberOfPoints="0" NumberOfCells="0">\n<Points/>\n</Piece>\n'
    for place in ("<PolyData>\n", "</Piece>\n"):
        (tmp_path / "layer.vtp").write_text(small_layers.xml().replace(place, place + empty, 1))
        assert described(good, "layer.vtp")["particles"] == small_layers.COUNT
