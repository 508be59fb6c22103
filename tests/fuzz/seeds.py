"""Writes the first inputs of every fuzz target, small ones, into FOLDER/TARGET: `seeds.py FOLDER`."""

import bz2
import gzip
import lzma
import sys
import tempfile
from pathlib import Path

import h5py
import numpy as np
import vtk
from vtk.util.numpy_support import numpy_to_vtk

REPORTS = Path(__file__).resolve().parents[1] / "data/reports"
ZSTD = (REPORTS / "a10.dump.zst").read_bytes()
DUMPS = Path(__file__).resolve().parents[1] / "data/dumps"
POINTS = np.array([[1.0, 2.0, 3.0], [4.5, -5.25, 6e-3], [7.0, 8.0, 9.0]])
RADII = np.array([0.5, 0.25, 0.125])
CSV = [
    b"x,y,z,radius\n1,2,3,0.5\n4,5,6,0.25\n",
    b"\xef\xbb\xbf# id;x [um];y (mm);z;diameter [nm];vx;vy;vz\r\n1;1;2;3;4;0;0;1\r\n2.0;+5;.5;1.e-3;1;1;0;0\r\n",
    b'"Points:0","Points:1","Points:2","Radius"\n1,2,3,4\n',
    b"y|x|position_z|mass\n1|2|3|4\n",
    b"  x y\tz r\n\n 1 2 3  4 \n",
]
DUMP = b"""ITEM: UNITS
micro
ITEM: TIME
0.5
ITEM: TIMESTEP
100
ITEM: NUMBER OF ATOMS
2
ITEM: BOX BOUNDS ff pp ff
-1 3
0 2
0 1e1
ITEM: ATOMS id type x y z radius vx vy vz
7 1 1 1 1 0.5 0 0 1
3 1 2 1 1 0.25 1 0 0
ITEM: TIMESTEP
200
ITEM: NUMBER OF ATOMS
1
ITEM: BOX BOUNDS ff pp ff
-1 3
0 2
0 1e1
ITEM: ATOMS id type xs yu zsu diameter omegax omegay omegaz
3 1 0.25 -1.5 0.125 0.5 1 2 3
"""
DATA = b"""LAMMPS data file

2 atoms
1 atom types

0 4 xlo xhi
0 2 ylo yhi
0 3 zlo zhi

Masses

1 1.0

Atoms # sphere

1 1 0.5 2500 1 1 1 0 -1 0
2 1 1 2500 2 1 1 0 0 0

Velocities

1 0 0 0 1 2 3
2 0 1 0 1 2 3
"""
YADE = [
    b"#format x_y_z_r\n1\t2\t3\t0.5\n4\t5\t6\t0.25\n",
    b"# by hand\n#format id_x_y_z_r_matId\n7 1 2 3 0.5 0\n8 4 5 6 0.25 0\n",
]
MERCURY = b"""2 0 0 0 0 4 2 3
1 1 1 0 0 0 0.5 0 0 0 0 0 0 0
2 1 1 0 0 0 0.25 0 0 0 0 0 0 0
1 0.125 0 0 0 4 2 3
3 1.5 1 0 0 -0.1 0.5 0 0 0 0 0 0 1
"""
XYZ = [
    b"""2
Lattice="4 0 0 0 2 0 0 0 3" Origin="-1 0 0" pbc="F T F" Properties=species:S:1:pos:R:3:velo:R:3:radius:R:1:id:I:1 Timestep=100 Time=0.5
P 1 1 0.5 4 5 6 0.5 7
Q 2 1 0.25 1 0 0 0.25 3
1
Properties={id:I:1:diameter:R:1:pos:R:3:type:I:1:w:R:3} Timestep=200 Time=1e0
7 0.5 1 1 1 2 0 nan 0
""",
    b"1\na comment\nP 1 2 3\n",
    b"0\nLattice='1 2 3' Properties=pos:R:3:r:R:1\n",
]
SERIES = [
    b'<VTKFile type="PUnstructuredGrid"><PUnstructuredGrid><Piece Source="a.vtu"/><Piece Source="a.vtu"/></PUnstructuredGrid></VTKFile>',
    b'<VTKFile type="vtkMultiBlockDataSet"><vtkMultiBlockDataSet><Block index="0"><DataSet index="0" file="b.csv"/></Block></vtkMultiBlockDataSet></VTKFile>',
    b'<VTKFile type="Collection"><Collection><DataSet timestep="0.5" part="0" file="c.pvtu"/><DataSet timestep="1" part="0" file="b.csv"/>'
    b'<DataSet timestep="1" part="1" file="d.pvd"/></Collection></VTKFile>',
    b'{"file-series-version": "1.0", "files": [{"name": "a.vtu", "time": 0.5}, {"name": "b.csv"}]}',
]
LEGACY = b"""# vtk DataFile Version 2.0
layer
ASCII
DATASET POLYDATA
POINTS 2 float
1 2 3 4 5
6
VERTICES 2 4
1 0
1 1
CELL_DATA 2
SCALARS radius float
LOOKUP_TABLE default
9 9
POINT_DATA 2
VECTORS v float
0 0 0 0 0 0
SCALARS diameter double 1
LOOKUP_TABLE default
1
0.5
COLOR_SCALARS c 2
0 0 1 1
TEXTURE_COORDINATES t 1 float
0 1
LOOKUP_TABLE l 1
0 0 0 0
FIELD more 2
stress 2 2 double
1 2
3 4
METADATA
NAME a

id 1 2 int
7 8
"""


def data_set(kind, real=np.float64):
    result = kind()
    holder = vtk.vtkPoints()
    holder.SetData(numpy_to_vtk(POINTS.astype(real), deep=True))
    result.SetPoints(holder)
    cells = vtk.vtkCellArray()
    for i in range(len(POINTS)):
        cells.InsertNextCell(1, [i])
    result.SetVerts(cells) if kind is vtk.vtkPolyData else result.SetCells(vtk.VTK_VERTEX, cells)
    for name, values in (("v", POINTS), ("id", np.arange(len(POINTS))), ("radii", RADII)):
        array = numpy_to_vtk(values, deep=True)
        array.SetName(name)
        result.GetPointData().AddArray(array)
    return result


def written(writer, data, settings):
    """The bytes that a writer of VTK makes."""
    for setting, *values in settings:
        getattr(writer, setting)(*values)
    with tempfile.NamedTemporaryFile() as file:
        writer.SetInputData(data)
        writer.SetFileName(file.name)
        assert writer.Write() == 1
        return Path(file.name).read_bytes()


def xml_files():
    encodings = [
        [("SetDataModeToAscii",)],
        [("SetDataModeToBinary",), ("SetCompressorTypeToNone",)],
        [("SetDataModeToBinary",), ("SetCompressorTypeToZLib",)],
        [("SetDataModeToAppended",), ("SetCompressorTypeToZLib",), ("SetHeaderTypeToUInt64",)],
        [("SetDataModeToAppended",), ("EncodeAppendedDataOff",), ("SetCompressorTypeToNone",), ("SetByteOrderToBigEndian",)],
    ]
    for settings in encodings:
        yield written(vtk.vtkXMLPolyDataWriter(), data_set(vtk.vtkPolyData), settings)
        yield written(vtk.vtkXMLUnstructuredGridWriter(), data_set(vtk.vtkUnstructuredGrid, np.float32), settings)


def legacy_files():
    yield LEGACY
    for version in (42, 51):
        for mode in ("SetFileTypeToASCII", "SetFileTypeToBinary"):
            yield written(vtk.vtkPolyDataWriter(), data_set(vtk.vtkPolyData), [("SetFileVersion", version), (mode,)])


def vtkhdf_file(path):
    """A VTKHDF PolyData of one step, as other codes write it."""
    with h5py.File(path, "w") as file:
        root = file.create_group("VTKHDF")
        root.attrs["Version"] = np.array([2, 0])
        root.attrs.create("Type", b"PolyData", dtype="S8")
        root["NumberOfPoints"] = np.array([len(POINTS)])
        root["Points"] = POINTS.astype(np.float32)
        root["PointData/radius"] = RADII
        root["PointData/velocity"] = POINTS
    return path.read_bytes()


def main(folder):
    real = {name: (DUMPS / name).read_bytes() for name in map(str, (p.name for p in DUMPS.iterdir()))}
    short = {name: b"".join(text.splitlines(keepends=True)[:14]) for name, text in real.items() if not name.endswith(".gz")}
    seeds = {
        "csv": CSV,
        "lammps-dump": [DUMP, DUMP[DUMP.index(b"ITEM: TIMESTEP") :], real["lammps-contacts.dump"], real["lammps-scaled.dump"]],
        "lammps-data": [DATA, real["lammps-write_data.data"]],
        "yade-text": [*YADE, short["yade-text.txt"]],
        "mercury-data": [MERCURY],
        "legacy-vtk": [*legacy_files(), real["liggghts-custom-452000.vtk"], real["liggghts-custom-boundingBox_452000.vtk"]],
        "vtk-xml": [*xml_files(), real["yade-spheres.2000.vtu"]],
        "gzip": [b"", CSV[0], real["lammps-custom.dump.gz"], gzip.compress(DUMP) + gzip.compress(CSV[0])],
        "extended-xyz": XYZ,
        "series": SERIES,
        "packed": [b"\0" + bz2.compress(CSV[0])[10:], b"\1" + lzma.compress(CSV[0])[6:], b"\2" + ZSTD[4:], b"\0x,y\n1,2\n"],
        "hdf5-arrays": [b"", bytes(range(64)), bytes(range(0, 255, 3))],
    }
    folder.mkdir(parents=True, exist_ok=True)
    seeds["hdf5-bytes"] = [vtkhdf_file(folder / "seed.vtkhdf")]
    (folder / "seed.vtkhdf").unlink()
    seeds["sniffing"] = [text for name, texts in seeds.items() if not name.startswith("hdf5") for text in texts[:3]]
    for target, texts in seeds.items():
        (folder / target).mkdir(exist_ok=True)
        for number, text in enumerate(texts):
            (folder / target / f"seed-{number}").write_bytes(text)


if __name__ == "__main__":
    main(Path(sys.argv[1]))
