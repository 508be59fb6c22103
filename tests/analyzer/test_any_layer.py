"""Layers of other codes with nothing said but the clearance and the density, and regions that do not fit them."""

import json
import time
from pathlib import Path

import h5py
import jsonschema
import numpy as np
import pytest

DUMPS = Path(__file__).resolve().parents[1] / "data/dumps"
LEAST = ["--set", "h_b=75um", "--set", "density=4430"]
QUICK = ["--set", "bootstrap_resamples=50"]


def dump(path, points, radii, period, step=1000):
    bounds = f"-1e-3 1e-1\n0 {period!r}\n0 1e-2\n"
    text = f"ITEM: TIMESTEP\n{step}\nITEM: NUMBER OF ATOMS\n{len(points)}\nITEM: BOX BOUNDS ff pp ff\n{bounds}ITEM: ATOMS id x y z radius\n"
    for number, (point, radius) in enumerate(zip(np.asarray(points).tolist(), np.asarray(radii).tolist(), strict=True), 1):
        text += f"{number} {' '.join(map(repr, point))} {radius!r}\n"
    path.write_text(text)
    return path


@pytest.fixture
def powder(tmp_path):
    """Log-normal spheres dropped on a plate of 2 x 0.7 mm, none on another: no length is a whole number of diameters."""
    generator = np.random.default_rng(5)
    placed = np.empty((0, 4))
    for radius in np.sort(np.exp(generator.normal(np.log(3.37e-5), 0.25, 150)))[::-1]:
        while True:
            x, y = generator.uniform(0, 2e-3), generator.uniform(0, 7e-4)
            across = np.abs(placed[:, 1] - y)
            distance = np.hypot(placed[:, 0] - x, np.minimum(across, 7e-4 - across))
            if (distance >= placed[:, 3] + radius).all():
                break
        placed = np.vstack([placed, (x, y, radius, radius)])
    points, radii = placed[:, :3], placed[:, 3]
    return dump(tmp_path / "powder.dump", points, radii, 7e-4), points, radii


def heights(points, radii, x, y, half, period):
    """Highest point of any sphere over each window, from the definition."""
    result = np.zeros((len(x), len(y)))
    dx = np.maximum(np.abs(points[:, 0] - x[:, None]) - half[0], 0)
    for turn in (-1, 0, 1):
        dy = np.maximum(np.abs(points[:, 1] + turn * period - y[:, None]) - half[1], 0)
        square = radii**2 - dx[:, None, :] ** 2 - dy[None, :, :] ** 2
        top = np.where(square > 1e-9 * 4.5e-9, points[:, 2] + np.sqrt(np.maximum(square, 0)), 0)
        result = np.maximum(result, top.max(axis=2))
    return result


def test_a_powder_with_a_size_distribution(good, tmp_path, root, powder):
    file, points, radii = powder
    text = good("metrics", file, *LEAST, *QUICK, "--json", "a.json", "--out", "a.h5", "--csv", "csv", "--vtk", "vtk", "--vdb", "a.vdb")
    report = json.loads((tmp_path / "a.json").read_text())
    d, period = report["config"]["d_p"], 7e-4 / report["config"]["d_p"]
    assert d == pytest.approx(2 * np.median(radii), rel=1e-5)
    assert abs(period - round(period)) > 0.1 and report["config"]["grid"] == 1
    cells = round(period)
    side = period / cells
    x0, x1 = report["config"]["x_range"]
    assert report["grid"]["cells"] == [round((x1 - x0) / d), cells]
    assert report["grid"]["cell"] == pytest.approx([1, side], rel=1e-9)
    assert report["grid"]["phi_window"] == pytest.approx([3, 3 * side], rel=1e-9)
    assert report["grid"]["height_window"] == pytest.approx([1, side], rel=1e-9)
    for n in (10, 20):
        assert report["voxel"][str(n)]["sides"] == pytest.approx([1 / n, period / round(period * n), 1 / n], rel=1e-9)
        assert 0 < report["voxel"][str(n)]["phi_max_error"] < 0.3 / n
    assert f"{len(report['maps']['height'])} x {cells} cells of 1 x {side:.6g} d_p" in text
    with h5py.File(tmp_path / "a.h5") as file:
        assert list(file["grid/cell"]) == report["grid"]["cell"] and list(file["grid/cells"]) == report["grid"]["cells"]
        assert list(file["voxel/10/sides"]) == report["voxel"]["10"]["sides"]
        x, y, height = (file["maps"][name][:] for name in ("height_x", "height_y", "height"))
        voxel_error = np.abs(file["voxel/10/phi"][:] - file["maps/phi_exact"][:]).max()
    np.testing.assert_allclose(y, 7e-4 * (np.arange(cells) + 0.5) / cells, rtol=1e-12)
    np.testing.assert_allclose(height * d, heights(points, radii, x, y, (d / 2, side * d / 2), 7e-4), atol=1e-12)
    assert report["voxel"]["10"]["phi_max_error"] == pytest.approx(voxel_error, rel=1e-12)
    schema = json.loads((root / "config/schema/report.schema.json").read_text())
    assert [error.message[:200] for error in jsonschema.Draft202012Validator(schema).iter_errors(report)] == []


def test_any_period_and_any_region(good, tmp_path, powder):
    file, _, _ = powder
    for period, region in ((6.9e-4, "0.1mm,1.9mm"), (7.77e-4, "0.123mm,1.777mm"), (1.31e-3, "0.5mm,0.9mm")):
        good("metrics", file, *LEAST, *QUICK, "--period", f"y=0,{period}", "--region", region, "--json", "a.json", "--quiet")
        report = json.loads((tmp_path / "a.json").read_text())
        d = report["config"]["d_p"]
        x0, x1 = report["config"]["x_range"]
        cells, cell = report["grid"]["cells"], report["grid"]["cell"]
        assert cells == [round((x1 - x0) / d), round(period / d)]
        assert [cells[0] * cell[0] * d, cells[1] * cell[1] * d] == pytest.approx([x1 - x0, period], rel=1e-9)


def test_a_grid_that_is_named_must_fit(good, refused, powder):
    file, _, _ = powder
    assert "y_period: the period is" in refused("metrics", file, *LEAST, "--set", "grid=1dp")
    assert "y_period: the period is 23.3333 cells of 3e-05 m" in refused("metrics", file, *LEAST, "--set", "grid=30um")
    good("metrics", file, *LEAST, *QUICK, "--set", "grid=35um")


@pytest.mark.parametrize("layer", ["powder", "lammps-layer.dump.gz"])
def test_tables_fit_a_terminal(good, tmp_path, powder, layer):
    file = powder[0] if layer == "powder" else DUMPS / layer
    region = ["--region", "1.6234mm,1.9771mm"]
    for command in (["metrics", file], ["metrics", file, *region], ["metrics", file, "--step", "all"], ["convergence", file]):
        lines = good(*command, *LEAST, *QUICK).splitlines()
        assert max(map(len, lines)) <= 80
        assert len(lines) > 1


def test_convergence_of_a_powder(good, tmp_path, powder):
    file, _, _ = powder
    text = good("convergence", file, *LEAST, *QUICK, "--json", "c.json")
    table = json.loads((tmp_path / "c.json").read_text())
    assert table["voxels_per_dp"] == [4, 5, 8, 10, 20, 40]
    errors = {quantity["name"]: [abs(e) for e in quantity["error"]] for quantity in table["quantities"]}
    assert errors["height, mean"][-1] < 0.2 * errors["height, mean"][0]
    assert errors["packing density, rms of nodes"][-1] < 0.2 * errors["packing density, rms of nodes"][0]
    assert all(f"n = {n}" in text for n in table["voxels_per_dp"])


def test_contacts_of_unequal_spheres(good, tmp_path):
    """Small and large spheres in touching rows, and the same drawn apart."""
    for name, mean, clusters in (("bidisperse", 0.8615, 4), ("bidisperse-apart", 0, 0)):
        text = good("metrics", DUMPS / f"{name}.dump.gz", *LEAST[2:], "--set", "h_b=100um", *QUICK, "--json", "a.json")
        report = json.loads((tmp_path / "a.json").read_text())
        assert report["clusters"]["cn_mean"] == pytest.approx(mean, abs=5e-5)
        assert report["clusters"]["n_clusters"] == clusters
        assert report["config"]["contact_mode"] == "radii"
        assert "contact_mode: radii" in text
        by_diameter = good("metrics", DUMPS / f"{name}.dump.gz", *LEAST[2:], "--set", "h_b=100um", "--set", "contact_mode=dp")
        assert "contact_mode: dp" in by_diameter


@pytest.mark.parametrize("rows", [1, 2, 3])
def test_neighbours_through_a_short_period(good, tmp_path, rows):
    points = [(i * 5e-5, (j + 0.5) * 5e-5, 2.5e-5) for i in range(40) for j in range(rows)]
    file = dump(tmp_path / "sheet.dump", points, [2.5e-5] * len(points), rows * 5e-5)
    good("metrics", file, *LEAST, "--set", "phi_window=1dp", "--json", "a.json", "--csv", "csv")
    report = json.loads((tmp_path / "a.json").read_text())
    assert report["clusters"]["cn_mean"] == 4
    assert report["uncertainty"]["clusters"]["cn_mean"]["value"] == 4
    assert report["clusters"]["max_cluster_size"] == len(points) and report["clusters"]["n_percolating"] == 1
    assert {line.split(",")[6] for line in (tmp_path / "csv/particles.csv").read_text().splitlines()[1:]} == {"3", "4"}


def test_a_region_without_particles(refused, good, powder):
    file, points, _ = powder
    began = time.monotonic()
    for region in ("1,2", "-2,-1", "0,2", "-1mm,1mm"):
        sentence = refused("metrics", file, *LEAST, "--region", region)
        assert f"error: --region {region}: " in sentence and "x_range" not in sentence and f"{points[:, 0].min():.9g} and {points[:, 0].max():.9g} m" in sentence
    assert time.monotonic() - began < 20
    assert "--set x_range=[1, 2]: x_range: no particle" in refused("metrics", file, *LEAST, "--set", "x_range=[1, 2]")
    assert "--region 1mm,1.001mm: the region is 1e-06 m long, less than half" in refused("metrics", file, *LEAST, "--region", "1mm,1.001mm")
    assert "--period y=0,1um: the period is 1e-06 m, less than half a cell" in refused("metrics", file, *LEAST, "--period", "y=0,1um")
    good("metrics", file, *LEAST, *QUICK, "--region", "-0.1mm,2.1mm")


def test_a_gap_between_particles_is_no_region(refused, tmp_path):
    points = [(x, 1e-4 * (k % 7), 2.5e-5) for x in (0, 2e-3) for k in range(7)]
    file = dump(tmp_path / "gap.dump", points, [2.5e-5] * len(points), 7e-4)
    for step in ("last", "all"):
        sentence = refused("metrics", file, *LEAST, "--region", "0.5mm,1.5mm", "--step", step)
        assert "no particle has its centre in the region x = 0.0005 ... 0.0015 m; they lie between x = 0 and 0.002 m" in sentence


def test_the_example_of_the_readme(good, root):
    """The layer that the documentation shows has contacts, clusters, holes and chambers to look at."""
    text = (root / "README.md").read_text()
    assert "tests/data/dumps/lammps-layer.dump.gz" in text
    lines = good("metrics", DUMPS / "lammps-layer.dump.gz", *LEAST).splitlines()
    rows = {line[:37].strip(): line[37:].split() for line in lines}
    assert float(rows["coordination number, mean"][0]) > 0.3
    assert float(rows["clusters of 2 or more, in the file"][0]) > 20
    assert float(rows["chamber pores, rule A"][0]) > 100
    assert 0.1 < float(rows["packing density, median"][0]) < 0.3
