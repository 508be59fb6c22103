"""What the program writes beside its reports, read back with VTK and numpy."""

import csv
import json
import subprocess
from pathlib import Path

import numpy as np
import pytest
import vtk
from vtk.util.numpy_support import vtk_to_numpy

CASES = Path(__file__).resolve().parents[1] / "data/cases"
NAME = "polydisperse"


@pytest.fixture(scope="module")
def outputs(build, tmp_path_factory):
    """Folder with all outputs of one layer."""
    folder = tmp_path_factory.mktemp("outputs")
    command = [build / "analyzer/recoat-analyze", "metrics", CASES / f"{NAME}.csv", "--config", CASES / f"{NAME}.cfg.json"]
    command += ["--json", folder / "out.json", "--csv", folder / "csv", "--vtk", folder / "vtk", "--vdb", folder / "out.vdb", "--quiet"]
    command += ["--set", "base=-10 um"]
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
    return folder


@pytest.fixture(scope="module")
def report(outputs):
    return json.loads((outputs / "out.json").read_text())


def read(file):
    """The data set of a VTK XML file."""
    reader = vtk.vtkXMLPolyDataReader() if file.suffix == ".vtp" else vtk.vtkXMLImageDataReader()
    errors = []
    reader.AddObserver("ErrorEvent", lambda *_: errors.append(file))
    reader.SetFileName(str(file))
    reader.Update()
    assert errors == []
    return reader.GetOutput()


def array(attributes, name):
    return vtk_to_numpy(attributes.GetArray(name))


def table(outputs, name):
    with open(outputs / "csv" / f"{name}.csv") as file:
        return list(csv.DictReader(file))


def numbers(rows, name):
    return np.array([float(row[name]) if row[name] else np.nan for row in rows])


def test_particles(outputs, report):
    data = read(outputs / "vtk/particles.vtp")
    points, values = vtk_to_numpy(data.GetPoints().GetData()), data.GetPointData()
    given = np.loadtxt(CASES / f"{NAME}.csv", delimiter=",", skiprows=1)
    np.testing.assert_allclose(points[:, [0, 2]], given[:, [0, 2]], rtol=1e-12)
    assert data.GetNumberOfVerts() == len(given)
    turns = (points[:, 1] - given[:, 1]) / report["config"]["y_period"]
    np.testing.assert_allclose(turns, np.round(turns), atol=1e-9)
    np.testing.assert_array_equal(array(values, "Radius"), given[:, 3])
    np.testing.assert_array_equal(array(values, "CoordinationNumber"), report["particles"]["cn"])
    np.testing.assert_array_equal(array(values, "ClusterSize"), report["particles"]["cluster_size"])
    angles = [np.nan if a is None else a for a in report["particles"]["cluster_angle"]]
    np.testing.assert_array_equal(array(values, "ClusterAngle"), angles)
    cluster = array(values, "Cluster")
    np.testing.assert_array_equal(np.bincount(cluster)[cluster], array(values, "ClusterSize"))
    assert array(values, "InRegion").sum() == report["clusters"]["n_particles"]


def polygon_areas(data):
    points = vtk_to_numpy(data.GetPoints().GetData())
    corners = vtk_to_numpy(data.GetPolys().GetConnectivityArray())
    ends = vtk_to_numpy(data.GetPolys().GetOffsetsArray())
    for begin, end in zip(ends[:-1], ends[1:]):
        x, y = points[corners[begin:end], :2].T
        yield 0.5 * np.sum(x * np.roll(y, -1) - y * np.roll(x, -1))


def test_chambers_are_discs_of_their_size(outputs, report):
    data = read(outputs / "vtk/chamber_pores_A.vtp")
    d = report["config"]["d_p"]
    circles = np.array(report["chamber_pores"]["A"]["circles_x_y_d"])
    diameter = array(data.GetCellData(), "Diameter")
    np.testing.assert_allclose(diameter, d * circles[:, 2], rtol=1e-12)
    points = vtk_to_numpy(data.GetPoints().GetData()).reshape(len(circles), 64, 3)
    centres = points.mean(axis=1)
    np.testing.assert_allclose(centres[:, 0], report["config"]["x_range"][0] + d * circles[:, 0], rtol=1e-9)
    np.testing.assert_allclose(centres[:, 2], -1e-5, rtol=1e-12)
    areas = np.array(list(polygon_areas(data)))
    np.testing.assert_allclose(areas, np.pi / 4 * diameter**2 * np.sin(2 * np.pi / 64) / (2 * np.pi / 64), rtol=1e-9)


@pytest.mark.parametrize("connectivity", ["4", "8"])
def test_density_pores_cover_their_cells(outputs, report, connectivity):
    data = read(outputs / f"vtk/density_pores_{connectivity}.vtp")
    d = report["config"]["d_p"]
    pores = report["density_pores"][connectivity]["pores"]
    assert len(pores) > 1
    number = array(data.GetCellData(), "Pore")
    areas = np.bincount(number, weights=np.array(list(polygon_areas(data))))[1:]
    np.testing.assert_allclose(areas, [pore["cells"] * d**2 for pore in pores], rtol=1e-9)
    assert (array(data.GetCellData(), "PackingDensity") < 0.1).all()
    angle = array(data.GetCellData(), "Angle")
    for index, pore in enumerate(pores):
        expected = pore.get("angle")
        assert np.all(np.isnan(angle[number == index + 1]) if expected is None else angle[number == index + 1] == expected)
    # A pore over the periodic boundary is in one piece.
    points = vtk_to_numpy(data.GetPoints().GetData()).reshape(-1, 4, 3)
    for index, pore in enumerate(pores):
        if "bbox" in pore:
            squares = points[number == index + 1].reshape(-1, 3)
            np.testing.assert_allclose(np.ptp(squares[:, :2], axis=0) / d, pore["bbox"], rtol=1e-9)


def test_maps(outputs, report):
    image = read(outputs / "vtk/maps.vti")
    d, shape = report["config"]["d_p"], np.array(report["maps"]["height"]).shape
    assert image.GetDimensions() == (shape[0] + 1, shape[1] + 1, 1)
    assert image.GetOrigin() == pytest.approx((report["config"]["x_range"][0], report["config"]["y_min"], -1e-5))
    assert image.GetSpacing()[:2] == pytest.approx((d, d))
    cells = image.GetCellData()
    for name, key, unit in (("PackingDensity", "phi_exact", 1), ("PackingDensityCentre", "phi_centre", 1), ("Height", "height", d), ("DensityPore8", "density_pore_8", 1)):
        found = array(cells, name).reshape(shape[1], shape[0]).T
        np.testing.assert_allclose(found, unit * np.array(report["maps"][key]), rtol=1e-15)


def test_csv_tables(outputs, report):
    particles, maps = table(outputs, "particles"), table(outputs, "maps")
    np.testing.assert_array_equal(numbers(particles, "cn"), report["particles"]["cn"])
    np.testing.assert_array_equal(numbers(maps, "phi_exact"), np.ravel(report["maps"]["phi_exact"]))
    assert (numbers(maps, "x")[0], numbers(maps, "y")[0]) == pytest.approx((2.5e-5, report["config"]["y_min"] + 2.5e-5))
    pores = report["density_pores"]["8"]["pores"]
    np.testing.assert_array_equal(numbers(table(outputs, "density_pores_8"), "cells"), [pore["cells"] for pore in pores])
    chambers = table(outputs, "chamber_pores")
    for rule in report["chamber_pores"]:
        found = sorted(float(row["diameter"]) for row in chambers if row["rule"] == rule)
        np.testing.assert_array_equal(found, report["chamber_pores"][rule]["sorted_sizes"])


def test_csv_metrics_have_every_number_and_its_interval(outputs, report):
    rows = {row["key"]: row for row in table(outputs, "metrics")}
    assert float(rows["height/Ra"]["value"]) == report["height"]["Ra"]
    ra = report["uncertainty"]["height"]["Ra"]
    assert [float(rows["height/Ra"][key]) for key in ra] == pytest.approx(list(ra.values()), rel=1e-14)
    shares = report["uncertainty"]["clusters"]["cn_fraction"]
    assert [float(rows[f"clusters/cn_fraction/{k}"]["upper"]) for k in range(len(shares["upper"]))] == shares["upper"]
    assert float(rows["voxel/20/phi_max_error"]["value"]) == report["voxel"]["20"]["phi_max_error"]
    assert rows["totals/area_m2"]["lower"] == ""
    assert not any(key.startswith(("maps", "particles", "config", "uncertainty")) for key in rows)
    with_interval = [key for key, row in rows.items() if row["lower"]]
    assert len(with_interval) > 100


def test_nothing_is_left_half_written(build, outputs, tmp_path):
    names = {file.name for file in outputs.rglob("*") if file.is_file()}
    assert len(names) == 15 and not any(name.startswith(".") or name.endswith((".part", ".tmp")) for name in names)
    command = [build / "analyzer/recoat-analyze", "metrics", CASES / f"{NAME}.csv", "--config", CASES / f"{NAME}.cfg.json"]
    done = subprocess.run([*command, "--vdb", tmp_path / "a.vdb", "--json", tmp_path / "a.json", "--set", "y_period=0.6 mm", "--set", "grid=0.5", "--set", "voxels_per_dp=[]", "--vdb-voxels", "0"], capture_output=True, text=True, check=False)
    assert done.returncode == 2 and "--vdb-voxels" in done.stderr
    assert list(tmp_path.iterdir()) == []


@pytest.mark.parametrize("ending", ["csv", "vtp", "dump", "vtkhdf"])
def test_conversion_keeps_velocities(build, tmp_path, ending):
    (tmp_path / "in.csv").write_text(
        "id,type,x,y,z,radius,vx,vy,vz,omegax,omegay,omegaz\n7,1,1e-4,2e-4,3e-5,2.5e-5,0.1,-0.2,0.30000000000000004,11,-12,13.5\n9,1,2e-4,2e-4,3e-5,2.5e-5,0,0,1e-17,0,0,1\n"
    )
    program = build / "analyzer/recoat-analyze"
    for source, target in (("in.csv", f"there.{ending}"), (f"there.{ending}", "back.csv")):
        done = subprocess.run([program, "convert", tmp_path / source, tmp_path / target], capture_output=True, text=True, check=False)
        assert done.returncode == 0, done.stderr
    given, back = (list(csv.DictReader(open(tmp_path / name))) for name in ("in.csv", "back.csv"))
    assert [{key: float(value) for key, value in row.items()} for row in back] == [{key: float(value) for key, value in row.items()} for row in given]
