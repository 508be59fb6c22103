"""VTK files of every kind, written by the vtk library, as the program reads them."""

import json
import subprocess

import numpy as np
import pytest
import vtk
from vtk.util.numpy_support import numpy_to_vtk

COUNT = 20_000  # more than a block of compressed data


@pytest.fixture(scope="module")
def particles():
    generator = np.random.default_rng(5)
    return generator.uniform(-1, 1, (COUNT, 3)), generator.uniform(1e-3, 2e-3, COUNT), generator.permutation(COUNT)


def data_set(kind, particles, real):
    points, radii, ids = particles
    result = kind()
    holder = vtk.vtkPoints()
    holder.SetData(numpy_to_vtk(points.astype(real), deep=True))
    result.SetPoints(holder)
    cells = vtk.vtkCellArray()
    for i in range(COUNT):
        cells.InsertNextCell(1, [i])
    result.SetVerts(cells) if kind is vtk.vtkPolyData else result.SetCells(vtk.VTK_VERTEX, cells)
    for name, values in (("velocity", points), ("id", ids), ("radii", radii)):
        array = numpy_to_vtk(values, deep=True)
        array.SetName(name)
        result.GetPointData().AddArray(array)
    return result


def write_xml(kind, writer, particles, real, path, settings):
    writer = writer()
    for setting, *values in settings:
        getattr(writer, setting)(*values)
    writer.SetInputData(data_set(kind, particles, real))
    writer.SetFileName(str(path))
    assert writer.Write() == 1


def check(build, path, particles, real, where, format_name):
    """Reads the extents: random numbers, so that a shift or a wrong type shows."""
    done = subprocess.run([build / "analyzer/recoat-analyze", "describe", path, "--json"], capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
    facts = json.loads(done.stdout)
    points, radii, _ = particles
    assert facts["format"] == format_name
    assert facts["particles"] == COUNT
    for axis, name in enumerate(("x [m]", "y [m]", "z [m]")):
        column = points[:, axis].astype(real).astype(float)
        tolerance = 1e-6 if where == "ascii" else 0  # digits of the writer
        assert facts[name] == pytest.approx([column.min(), column.max()], rel=tolerance, abs=0)
        assert facts["mean " + name] == pytest.approx(column.mean(), rel=1e-5)
    assert facts["radius [m]"] == pytest.approx([radii.min(), radii.max()], rel=1e-6 if where == "ascii" else 0, abs=0)


ENCODINGS = {
    "ascii": [("SetDataModeToAscii",)],
    "inline": [("SetDataModeToBinary",), ("SetCompressorTypeToNone",)],
    "inline_zlib": [("SetDataModeToBinary",), ("SetCompressorTypeToZLib",)],
    "appended": [("SetDataModeToAppended",), ("EncodeAppendedDataOff",), ("SetCompressorTypeToNone",)],
    "appended_zlib": [("SetDataModeToAppended",), ("EncodeAppendedDataOff",), ("SetCompressorTypeToZLib",)],
    "appended_base64": [("SetDataModeToAppended",), ("EncodeAppendedDataOn",), ("SetCompressorTypeToNone",)],
    "appended_base64_zlib": [("SetDataModeToAppended",), ("EncodeAppendedDataOn",), ("SetCompressorTypeToZLib",), ("SetHeaderTypeToUInt32",)],
    "header64": [("SetDataModeToAppended",), ("EncodeAppendedDataOn",), ("SetCompressorTypeToZLib",), ("SetHeaderTypeToUInt64",)],
    "small_blocks": [("SetDataModeToBinary",), ("SetCompressorTypeToZLib",), ("SetBlockSize", 4096)],
    "big_endian": [("SetByteOrderToBigEndian",), ("SetDataModeToAppended",), ("SetCompressorTypeToZLib",)],
}


@pytest.mark.parametrize("real", [np.float32, np.float64])
@pytest.mark.parametrize("where", ENCODINGS)
def test_vtp(build, tmp_path, particles, where, real):
    path = tmp_path / "layer.vtp"
    write_xml(vtk.vtkPolyData, vtk.vtkXMLPolyDataWriter, particles, real, path, ENCODINGS[where])
    check(build, path, particles, real, where, "vtk-xml")


@pytest.mark.parametrize("where", ["ascii", "inline_zlib", "appended"])
def test_vtu(build, tmp_path, particles, where):
    path = tmp_path / "layer.vtk"  # the ending says nothing
    write_xml(vtk.vtkUnstructuredGrid, vtk.vtkXMLUnstructuredGridWriter, particles, np.float64, path, ENCODINGS[where])
    check(build, path, particles, np.float64, where, "vtk-xml")


def test_other_compressions_are_refused_by_name(build, tmp_path, particles):
    path = tmp_path / "layer.vtp"
    write_xml(vtk.vtkPolyData, vtk.vtkXMLPolyDataWriter, particles, np.float32, path, [("SetCompressorTypeToLZ4",)])
    done = subprocess.run([build / "analyzer/recoat-analyze", "describe", path], capture_output=True, text=True, check=False)
    assert done.returncode == 2
    assert "compressed by vtkLZ4DataCompressor" in done.stderr


@pytest.mark.parametrize("real", [np.float32, np.float64])
@pytest.mark.parametrize("where", ["ascii", "binary"])
@pytest.mark.parametrize("version", [42, 51])
@pytest.mark.parametrize("kind", ["PolyData", "UnstructuredGrid"])
def test_legacy(build, tmp_path, particles, kind, version, where, real):
    path = tmp_path / "layer.vtk"
    writer = getattr(vtk, f"vtk{kind}Writer")()
    writer.SetFileVersion(version)
    writer.SetFileTypeToASCII() if where == "ascii" else writer.SetFileTypeToBinary()
    writer.SetInputData(data_set(getattr(vtk, f"vtk{kind}"), particles, real))
    writer.SetFileName(str(path))
    assert writer.Write() == 1
    check(build, path, particles, real, where, "legacy-vtk")


@pytest.mark.parametrize("share", [0.1, 0.5, 0.9, 0.999])
@pytest.mark.parametrize("where", ["ascii", "inline_zlib", "appended", "legacy"])
def test_truncated_files_are_refused(build, tmp_path, particles, where, share):
    whole, path = tmp_path / "whole", tmp_path / "cut"
    if where == "legacy":
        writer = vtk.vtkPolyDataWriter()
        writer.SetFileTypeToBinary()
        writer.SetInputData(data_set(vtk.vtkPolyData, particles, np.float32))
        writer.SetFileName(str(whole))
        writer.Write()
    else:
        write_xml(vtk.vtkPolyData, vtk.vtkXMLPolyDataWriter, particles, np.float32, whole, ENCODINGS[where])
    content = whole.read_bytes()
    path.write_bytes(content[: int(share * len(content))])
    done = subprocess.run([build / "analyzer/recoat-analyze", "describe", path], capture_output=True, text=True, check=False)
    assert done.returncode == 2
    assert len(done.stderr.splitlines()) == 1
    assert "cut:" in done.stderr
