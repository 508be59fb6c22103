"""Layers of other codes: options, region and base, conversion, bad files. The small files are cut from real ones."""

import gzip
import json
import random
from pathlib import Path

import h5py
import numpy as np
import pytest

DUMPS = Path(__file__).resolve().parents[1] / "data/dumps"
LAYERS = {
    "lammps-custom.dump.gz": "lammps-dump",
    "lammps-scaled.dump": "lammps-dump",
    "lammps-write_data.data": "lammps-data",
    "liggghts-atom-452000.vtk": "vtk-xml",
    "liggghts-custom-452000.vtk": "legacy-vtk",
    "yade-spheres.2000.vtu": "vtk-xml",
    "yade-text.txt": "yade-text",
}


def table(path):
    """Rows x, y, z, radius of a converted table."""
    names = path.read_text().split("\n")[0].split(",")
    rows = np.loadtxt(path, delimiter=",", skiprows=1)
    return rows[:, [names.index(n) for n in ("x", "y", "z", "radius")]]


@pytest.mark.parametrize("name", LAYERS)
def test_formats_are_told_by_their_content(good, tmp_path, name):
    (tmp_path / "layer").write_bytes((DUMPS / name).read_bytes())
    assert json.loads(good("describe", "layer", "--json"))["format"] == LAYERS[name]


def test_describe_lists_the_formats(good):
    assert {line.split()[0] for line in good("describe").splitlines()} >= {*LAYERS.values(), "csv", "recoat-state", "mercury-data"}


@pytest.mark.parametrize("name", LAYERS)
def test_conversion_keeps_every_bit(good, tmp_path, name):
    good("convert", DUMPS / name, "first.csv")
    chain = ["first.csv", "a.vtp", "b.dump", "c.vtkhdf", "d.lammpstrj", "last.csv"]
    for source, target in zip(chain, chain[1:]):
        good("convert", source, target)
    assert np.array_equal(table(tmp_path / "first.csv"), table(tmp_path / "last.csv"))


def test_conversion_by_name_and_unit(good, refused, tmp_path):
    good("convert", DUMPS / "yade-text.txt", "layer.txt", "--format", "csv", "--length-unit", "um")
    metres = np.loadtxt(DUMPS / "yade-text.txt")
    assert table(tmp_path / "layer.txt") == pytest.approx(metres * 1e-6, rel=1e-14)
    assert "ending" in refused("convert", DUMPS / "yade-text.txt", "layer.what")
    assert "no format \"obj\"" in refused("convert", DUMPS / "yade-text.txt", "layer.csv", "--format", "obj")


def test_vtp_and_vtkhdf_hold_what_other_programs_expect(good, tmp_path):
    import vtk
    from vtk.util.numpy_support import vtk_to_numpy

    good("convert", DUMPS / "lammps-write_data.data", "layer.csv")
    rows = table(tmp_path / "layer.csv")
    for name, reader in (("layer.vtp", vtk.vtkXMLPolyDataReader()), ("layer.vtkhdf", vtk.vtkHDFReader())):
        good("convert", "layer.csv", name)
        reader.SetFileName(str(tmp_path / name))
        reader.Update()
        data = reader.GetOutput()
        assert np.array_equal(vtk_to_numpy(data.GetPoints().GetData()), rows[:, :3])
        assert np.array_equal(vtk_to_numpy(data.GetPointData().GetArray("Radius")), rows[:, 3])
        assert data.GetVerts().GetNumberOfCells() == len(rows)


def test_frame_of_a_foreign_layer(good, tmp_path):
    """Region, period and base as the particles and the box show them; a window as counted by hand."""
    file = DUMPS / "lammps-write_data.data"
    rows = np.array([line.split()[4:7] for line in file.read_text().splitlines()[11:111]], dtype=float)
    text = good("metrics", file, "--set", "h_b=75um", "--json", "all.json")
    low, high = rows[:, 0].min(), rows[:, 0].max()
    begin, cells = low + 5e-5, int((high - low - 1e-4) / 5e-5)
    region = json.loads((tmp_path / "all.json").read_text())["config"]["x_range"]
    assert region == pytest.approx([begin, begin + cells * 5e-5], rel=1e-12)
    assert "base z = 0 m" in text and "y period 0.001 m (20 d_p)" in text and "d_p 5e-05 m" in text
    good("metrics", file, "--set", "h_b=75um", "--region", "2mm,4mm", "--out", "window.h5", "--json", "window.json")
    inside = (rows[:, 0] >= 2e-3) & (rows[:, 0] < 4e-3)
    volume = json.loads((tmp_path / "window.json").read_text())["totals"]["volume_whole_m3"]
    assert volume == pytest.approx(inside.sum() * np.pi * 5e-5**3 / 6, rel=1e-9)
    good("metrics", file, "--set", "h_b=75um", "--base", "10um", "--region", "2mm,4mm", "--out", "raised.h5")
    with h5py.File(tmp_path / "window.h5") as window, h5py.File(tmp_path / "raised.h5") as raised:
        assert window["particles/z"][:] - 1e-5 == pytest.approx(raised["particles/z"][:], abs=1e-15)


def test_period_by_option(good, refused):
    arguments = ["metrics", DUMPS / "yade-text.txt", "--set", "h_b=75um", "--set", "density=4430"]
    assert "--period y=LOWER,UPPER" in refused(*arguments)
    assert "y from 0 m" in good(*arguments, "--period", "y=0,1mm")
    assert "does not begin with y=" in refused(*arguments, "--period", "x=0,1mm")
    assert "ends before it begins" in refused(*arguments, "--period", "y=1mm,0")
    assert "two lengths" in refused(*arguments, "--region", "1mm")
    assert "h_b: the file of particles does not say the clearance" in refused("metrics", DUMPS / "yade-text.txt")


def test_options_are_checked(refused):
    file = DUMPS / "lammps-scaled.dump"
    assert "--length-unit" in refused("describe", file, "--length-unit", "inch")
    assert "--radius: \"0\" is not above zero" in refused("describe", file, "--radius", "0")
    assert "leave the radius out" in refused("describe", file, "--radius", "25um")
    assert "no column \"size\"" in refused("describe", file, "--diameter-column", "size")
    assert "--step: \"any\" is no time step" in refused("describe", file, "--step", "any")
    assert "there is no time step 7; the file has 1: 452000" in refused("describe", file, "--step", "7")


@pytest.mark.parametrize("share", [0.05, 0.3, 0.6, 0.95])
@pytest.mark.parametrize("name", [n for n in LAYERS if n != "yade-text.txt"])
def test_cut_files_are_refused(refused, tmp_path, name, share):
    content = (DUMPS / name).read_bytes()
    if name.endswith(".data"):  # velocities are not read
        content = content[: content.index(b"Velocities")].rstrip()
    (tmp_path / "layer").write_bytes(content[: int(share * len(content))])
    assert "layer:" in refused("convert", "layer", "out.csv")


def test_garbage_is_refused(refused, tmp_path):
    generator = random.Random(3)
    letters = "".join(generator.choices("abcdefghij 0123456789.-", k=40))
    garbage = {
        "lines": (letters + "\n").encode() * 1_000_000,
        "one_line": letters.encode() * 100_000,
        "bytes": generator.randbytes(100_000),
        "zeros": bytes(1000),
        "blank": b"\n \n\t\n",
        "nothing": b"",
        "packed_nothing": gzip.compress(b""),
        "packed_bytes": gzip.compress(generator.randbytes(1000)),
        "damaged": (DUMPS / "lammps-custom.dump.gz").read_bytes()[:-300] + bytes(300),
    }
    for name, content in garbage.items():
        (tmp_path / name).write_bytes(content)
        assert f"{name}:" in refused("convert", name, "out.vtp")


# What stands before the place where the bytes go, in arrays that are read.
BEFORE_NUMBERS = {
    "lammps-scaled.dump": b"2061 1",
    "lammps-write_data.data": b"2061 1",
    "liggghts-atom-452000.vtk": b'Name="Points"',
    "liggghts-custom-452000.vtk": b"POINTS",
    "yade-spheres.2000.vtu": b"   _",
    "yade-text.txt": b"x_y_z_r",
}


@pytest.mark.parametrize("name", BEFORE_NUMBERS)
def test_binary_where_text_is_expected(refused, tmp_path, name):
    content = bytearray((DUMPS / name).read_bytes())
    mark = BEFORE_NUMBERS[name]
    place = content.index(mark) + len(mark) + 100
    content[place : place + 40] = bytes(range(128, 168))
    (tmp_path / "layer").write_bytes(content)
    sentence = refused("convert", "layer", "out.csv")
    assert "layer:" in sentence
    assert sentence.rstrip("\n").isprintable()
