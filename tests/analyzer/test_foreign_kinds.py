"""Files that hold no list of particles, or hold it in a way that is not read: one sentence that names what they are."""

import gzip
import io
import tarfile
from pathlib import Path

import h5py
import numpy as np
import pytest

REPORTS = Path(__file__).resolve().parents[1] / "data/reports"


@pytest.mark.parametrize(
    ("file", "sentence"),
    [
        ("a10.zip", "this is a zip archive (or a workbook of Excel); unpack it, or save the sheet as CSV"),
        ("a23_grid.dump", "this is a dump of a grid, which holds no particles; give the dump of the atoms"),
        ("a23_gsd.gsd", "this is a GSD file of HOOMD-blue, which is not read"),
        ("a23_local_label.dump", "this dump lists contacts (local entries such as contacts or bonds), not particles"),
        ("a23_phasicflow.txt", "this is a field of phasicFlow, which keeps positions and sizes in files of their own"),
        ("a23_restart.mercury", "this is a restart file of MercuryDPM, not its list of particles; give the .data file"),
        ("a23_yaml.yaml", "this is a YAML dump of LAMMPS, which is not read; dump the atoms with the style custom"),
    ],
)
def test_files_of_users(refused, file, sentence):
    assert f"{file}: {sentence}" in refused("describe", REPORTS / file)


def tar_of(text):
    stream = io.BytesIO()
    with tarfile.open(fileobj=stream, mode="w") as archive:
        entry = tarfile.TarInfo("layer.csv")
        entry.size = len(text)
        archive.addfile(entry, io.BytesIO(text))
    return stream.getvalue()


def npy():
    stream = io.BytesIO()
    np.save(stream, np.zeros((2, 4)))
    return stream.getvalue()


@pytest.mark.parametrize(
    ("content", "kind"),
    [
        (gzip.compress(tar_of(b"x,y,z,r\n1,2,3,1\n")), "a tar archive"),
        (tar_of(b"x,y,z,r\n1,2,3,1\n"), "a tar archive"),
        (npy(), "an array of numpy"),
        (b"LammpS RestartT\0\1\0", "a restart file of LAMMPS"),
        (b"CDF\x01\0\0\0\0", "a NetCDF file"),
        (b"solid plate\nfacet normal 0 0 1\n", "a surface of triangles (STL)"),
        (b"\xd0\xcf\x11\xe0\xa1\xb1\x1a\xe1", "a document of an old Office"),
        (b"LAMMPS (2 Aug 2023)\n", "the log of a LAMMPS run"),
        (b"\n<!DOCTYPE html>\n<html>", "a page of the web"),
        (b"version https://git-lfs.github.com/spec/v1\noid sha256:0\nsize 3\n", "a pointer of Git LFS"),
        (b"FoamFile\n{\n version 2.0;\n}\n(1 2 3)\n", "a field of OpenFOAM"),
        (b"---\nspheres:\n- [1, 2, 3]\n", "a YAML file"),
        (b"%YAML 1.1\n---\n{spheres: []}\n", "a YAML file"),
        (b"x,y,z,radius\r1,2,3,1\r", "text whose lines end with carriage returns alone"),
        (b"ITEM: TIMESTEP\n0\nITEM: NUMBER OF BONDS\n1\nITEM: BOX BOUNDS ff ff ff\n0 1\n0 1\n0 1\nITEM: BONDS a b\n1 2\n", "dump lists bonds"),
        (b'<?xml version="1.0" ?>\n<Xdmf Version="3.0">\n</Xdmf>', "an XDMF head"),
    ],
)
def test_other_kinds(refused, tmp_path, content, kind):
    (tmp_path / "layer").write_bytes(content)
    assert f"layer: this {'' if kind.startswith('dump') else 'is '}{kind}" in refused("describe", "layer")


def test_a_collection_in_hdf5(good, refused, tmp_path):
    """The particles are the only data set with points, or the only one with sizes: walls have none."""

    def add(root, name, **arrays):
        block = root.create_group(name)
        block.attrs["Type"] = np.bytes_("PolyData" if arrays else "ImageData")
        block["NumberOfPoints"] = [2]
        block["Points"] = np.array([[1.0, 2, 3], [4, 5, 6]])
        for array, values in arrays.items():
            block[f"PointData/{array}"] = values

    with h5py.File(tmp_path / "layer", "w") as file:
        root = file.create_group("VTKHDF")
        root.attrs["Type"] = np.bytes_("PartitionedDataSetCollection")
        root.create_group("Assembly")
        add(root, "grid")
        add(root, "grains", diameter=[1.0, 0.5])
    assert "particles            2" in good("describe", "layer")
    with h5py.File(tmp_path / "layer", "r+") as file:
        add(file["VTKHDF"], "plates", force=[1.0, 2.0])
    good("convert", "layer", "out.csv")
    assert (tmp_path / "out.csv").read_text().splitlines()[1].endswith("1,2,3,0.5")
    (tmp_path / "out.csv").unlink()
    with h5py.File(tmp_path / "layer", "r+") as file:
        add(file["VTKHDF"], "more", Radius=[1.0, 0.5])
    sentence = "layer: the file is a collection of data sets (grains, grid, more, plates), several of them with particles"
    assert sentence in refused("describe", "layer")
    good("describe", "layer", "--diameter-column", "diameter")
