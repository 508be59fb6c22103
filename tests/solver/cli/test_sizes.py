"""Powders of unequal spheres through the whole line."""

import json
import math
import subprocess

import h5py
import numpy as np
import pytest
import yaml

SIZES = {
    "normal": "{distribution: normal, mean: 48 um, standard_deviation: 8 um, smallest: 30 um, largest: 65 um}",
    "log_normal": "{distribution: log_normal, median: 50 um, geometric_deviation: 1.25, smallest: 32 um, "
    "largest: 70 um, weighting: mass}",
    "table": "{distribution: table, diameters: [30 um, 40 um, 60 um], cumulative: [0, 0.4, 1]}",
}


@pytest.fixture(params=SIZES)
def unequal(solver, request):
    """A small spread of 60 unequal spheres."""
    text = (solver.folder / "spread.yaml").read_text()
    text = text.replace("powder: {particles: 40}", f"powder: {{particles: 60, sizes: {SIZES[request.param]}}}")
    text = text.replace("width: 4 dp", "width: 6 dp").replace("time_step: 1e-7 s", "time_step: 5e-8 s")
    solver.write("unequal.yaml", text)
    solver.kind = request.param
    return solver


def states(folder):
    for name in ("fill", "heap", "spread"):
        with h5py.File(folder / f"{name}.vtkhdf") as file:
            yield file["VTKHDF/Points"][()], file["VTKHDF/PointData/Radius"][()]


def test_unequal_spheres_are_filled_heaped_and_spread(unequal):
    for threads in (1, 2):
        unequal.good("run", "unequal.yaml", "--out", f"out{threads}", "--threads", threads, "--quiet")
    summary = unequal.summary("out1")
    assert summary["status"] == "finished" and summary["particles"] == 60 and summary["particles_lost"] == 0
    assert all(stage["largest_overlap"] < 0.05 for stage in summary["stages"])
    assert abs(summary["stages"][2]["energy"]["balance_error_relative"]) < 0.02
    radii = None
    for (points, radius), (again, _) in zip(states(unequal.folder / "out1"), states(unequal.folder / "out2")):
        assert points.tobytes() == again.tobytes()
        assert radii is None or np.array_equal(radii, radius)
        radii = radius
        assert len(np.unique(radius)) == 60
        assert 15e-6 <= radius.min() and radius.max() <= 35e-6
        assert np.all(points[:, 2] >= 0.99 * radius)  # nothing has sunk into the base


def test_the_layer_is_analysed(unequal, build):
    unequal.good("run", "unequal.yaml", "--out", "out", "--threads", 1, "--quiet")
    state = unequal.folder / "out/spread.vtkhdf"
    words = [build / "analyzer/recoat-analyze", "metrics", state, "--set", "x_range=[1 dp, 12 dp]", "--json", "layer.json"]
    done = subprocess.run(words, cwd=unequal.folder, capture_output=True, text=True, timeout=120, check=False)
    assert done.returncode == 0, done.stderr
    totals = json.loads((unequal.folder / "layer.json").read_text())["totals"]
    with h5py.File(state) as file:
        x, radius = file["VTKHDF/Points"][:, 0], file["VTKHDF/PointData/Radius"][()]
    inside = (x >= 50e-6) & (x < 600e-6)
    assert inside.any()
    assert totals["volume_whole_m3"] == pytest.approx(np.sum(4 / 3 * math.pi * radius[inside] ** 3), rel=1e-9)


def test_check_tells_the_sizes(unequal):
    report = json.loads(unequal.good("check", "unequal.yaml", "--json"))
    sizes = report["sizes"]
    bounds = {"normal": (30e-6, 65e-6), "log_normal": (32e-6, 70e-6), "table": (30e-6, 60e-6)}[unequal.kind]
    assert (sizes["smallest"], sizes["largest"]) == pytest.approx(bounds)
    assert sizes["smallest"] < sizes["median_by_number"] < sizes["median_by_mass"] < sizes["largest"]
    assert sizes["mean"] < sizes["sauter"]
    assert sizes["bond_number"]["smallest"] == pytest.approx(5 * (50e-6 / bounds[0]) ** 2)
    rayleigh = {limit["name"]: limit["limit"] for limit in report["time_step_limits"]}["Rayleigh time"]
    assert rayleigh == pytest.approx(8.6834e-7 * bounds[0] / 50e-6, rel=1e-4)
    text = unequal.good("check", "unequal.yaml")
    assert "Sauter diameter" in text and "Bond number, pair of the smallest" in text


def test_print_config_keeps_the_sizes(unequal, validator):
    text = unequal.good("run", "unequal.yaml", "--print-config")
    config = yaml.safe_load(text)
    validator.validate(config)
    assert config["powder"]["sizes"]["weighting"] == ("mass" if unequal.kind == "log_normal" else "number")
    unequal.write("again.yaml", text)
    assert unequal.good("run", "again.yaml", "--print-config") == text


@pytest.mark.parametrize(
    "key, value",
    [
        ("distribution", "uniform"),
        ("distribution", None),
        ("smallest", "30"),
        ("geometric_deviation", 1),
        ("geometric_deviation", 11),
        ("weighting", "volume"),
        ("mean", "50 um"),
        ("largest", None),
    ],
)
def test_schema_and_reader_refuse_alike(solver, validator, key, value):
    config = yaml.safe_load((solver.folder / "spread.yaml").read_text())
    config["box"]["width"] = "8 dp"
    config["powder"]["sizes"] = yaml.safe_load(SIZES["log_normal"])
    assert validator.is_valid(config)
    config["powder"]["sizes"][key] = value
    if value is None:
        del config["powder"]["sizes"][key]
    assert not validator.is_valid(config)
    solver.write("bad.yaml", yaml.safe_dump(config, sort_keys=False))
    assert "powder.sizes" in solver.refusal("run", "bad.yaml", "--print-config")


def test_the_powders_of_the_readme_are_good(solver, root):
    powders = [line.strip() for line in (root / "README.md").read_text().splitlines() if line.startswith("    powder:")]
    assert len(powders) == 2
    text = (solver.folder / "spread.yaml").read_text().replace("width: 4 dp", "width: 6 dp")
    for powder in powders:
        solver.write("readme.yaml", text.replace("powder: {particles: 40}", powder).replace("1e-7 s", "5e-8 s"))
        sizes = json.loads(solver.good("check", "readme.yaml", "--json"))["sizes"]
        assert sizes["smallest"] == pytest.approx(30e-6)
