"""The program on the layers of tests/data/cases: every expected value it measures."""

import json
import subprocess
from pathlib import Path

import h5py
import jsonschema
import numpy as np
import pytest
import yaml
from comparison import differences as all_differences

CASES = Path(__file__).resolve().parents[1] / "data/cases"
NAMES = sorted(file.stem for file in CASES.glob("*.csv"))


@pytest.fixture(scope="module")
def program(build):
    return build / "analyzer/recoat-analyze"


@pytest.fixture(scope="module", params=NAMES)
def case(request, program, tmp_path_factory):
    """Name, expected values, JSON report and HDF5 report of a case."""
    name = request.param
    folder = tmp_path_factory.mktemp(name)
    report, tables = folder / "out.json", folder / "out.h5"
    command = [program, "metrics", CASES / f"{name}.csv", "--config", CASES / f"{name}.cfg.json", "--json", report, "--out", tables]
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
    expected = json.loads((CASES / f"{name}.json").read_text())
    return name, expected, json.loads(report.read_text()), tables


def test_all_cases_are_there():
    assert len(NAMES) == 8


# What the reference program of the expected values does not compute; it has tests of its own.
BEYOND = {"/uncertainty", "/config/base", "/grid", "/maps/density_pore_4", "/maps/density_pore_8"} | {
    f"/config/bootstrap_{name}" for name in ("block", "resamples", "seed")
}
BEYOND |= {f"/voxel/{n}/{name}" for n in (4, 10, 20, 40) for name in ("chamber_P_errors", "density_pore_errors_8", "sides")}


def differences(expected, report):
    if "contact_mode" in report.get("config", {}):
        # Of equal spheres both modes say the same; a case whose radii differ names its mode in its configuration.
        expected = {**expected, "config": {**expected["config"], "contact_mode": report["config"]["contact_mode"]}}
    return [found for found in all_differences(expected, report) if found not in [(path, "is not expected") for path in BEYOND]]


def test_every_expected_value(case):
    _, expected, report, _ = case
    assert list(differences(expected, report)) == []


def test_comparison_sees_wrong_values(case):
    _, expected, report, _ = case

    def found(**changes):
        return {path for path, _ in differences(expected, {**report, **changes})}

    totals, clusters = report["totals"], report["clusters"]
    assert found(totals={**totals, "area_m2": totals["area_m2"] * (1 + 3e-6)}) == {"/totals/area_m2"}
    assert found(clusters={**clusters, "n_contacts": clusters["n_contacts"] + 1}) == {"/clusters/n_contacts"}
    assert found(clusters={k: v for k, v in clusters.items() if k != "cn_mean"}) == {"/clusters/cn_mean"}
    assert found(more=1) == {"/more"}
    assert found(maps={**report["maps"], "height": report["maps"]["height"][:-1]}) == {"/maps/height"}
    chambers = report["chamber_pores"]
    sizes = chambers["A"]["sorted_sizes"]
    assert found(chamber_pores={**chambers, "A": {**chambers["A"], "mean": chambers["A"]["mean"] * (1 + 3e-6) + 3e-6}}) == {"/chamber_pores/A/mean"}
    assert "/chamber_pores/A/sorted_sizes" in found(chamber_pores={**chambers, "A": {**chambers["A"], "sorted_sizes": [*sizes, 7, 8, 9]}})
    rows = [[value + 2e-6 for value in row] for row in report["maps"]["phi_exact"]]
    assert len(found(maps={**report["maps"], "phi_exact": rows})) == sum(len(row) for row in rows)


def test_hdf5_holds_the_same_values(case):
    _, _, report, tables = case
    with h5py.File(tables) as file:
        for name in ("phi_exact", "phi_centre", "height"):
            np.testing.assert_array_equal(file["maps"][name][:], np.array(report["maps"][name]))
        angles = [np.nan if a is None else a for a in report["particles"]["cluster_angle"]]
        np.testing.assert_array_equal(file["particles/cluster_angle"][:], angles)
        np.testing.assert_array_equal(file["particles/cn"][:], np.array(report["particles"]["cn"], dtype=int))
        np.testing.assert_array_equal(file["particles/cluster_size"][:], np.array(report["particles"]["cluster_size"], dtype=int))
        assert file["phi_exact/median"][0] == report["phi_exact"]["median"]
        assert file["height/Ra"][0] == report["height"]["Ra"]
        assert file["totals/layer_phi"][0] == report["totals"]["layer_phi"]
        assert file["voxel/20/phi_max_error"][0] == report["voxel"]["20"]["phi_max_error"]
        for rule, pores in report["chamber_pores"].items():
            np.testing.assert_array_equal(file["chamber_pores"][rule]["sorted_sizes"][:], pores["sorted_sizes"])
        circles = np.array(report["chamber_pores"]["A"]["circles_x_y_d"]).reshape(-1, 3)
        d, x0 = report["config"]["d_p"], report["config"]["x_range"][0]
        np.testing.assert_allclose(file["chamber_pores/A/circles/x"][:], x0 + d * circles[:, 0], rtol=1e-12, atol=1e-18)
        np.testing.assert_array_equal(file["chamber_pores/A/circles/diameter"][:], circles[:, 2])
        for connectivity, pores in report["density_pores"].items():
            table = file["density_pores"][connectivity]["pores"]
            np.testing.assert_array_equal(table["cells"][:], np.array([p["cells"] for p in pores["pores"]], dtype=int))
            angles = [p.get("angle") for p in pores["pores"]]
            np.testing.assert_array_equal(table["angle"][:], [np.nan if a is None else a for a in angles])
        assert file["config"].attrs["d_p"] == report["config"]["d_p"]
        assert json.loads(file["config"].attrs["x_range"]) == report["config"]["x_range"]


def test_hdf5_carries_units_and_definitions(case):
    _, _, report, tables = case
    arrays = []
    with h5py.File(tables) as file:
        file.visititems(lambda name, item: arrays.append(name) if isinstance(item, h5py.Dataset) else None)
        undescribed = [a for a in arrays if not file[a].attrs.get("unit") or not file[a].attrs.get("definition")]
        x = file["maps/height_x"][:]
    assert len(arrays) > 80
    assert undescribed == []
    start, end = report["config"]["x_range"]
    np.testing.assert_allclose(x, np.linspace(start, end, 2 * len(x) + 1)[1::2], rtol=1e-12)


def test_hdf5_particles_are_those_of_the_file(case):
    name, _, report, tables = case
    lines = (CASES / f"{name}.csv").read_text().splitlines()[1:]
    file_particles = np.array([[float(cell) for cell in line.split(",")] for line in lines]).reshape(-1, 4)
    period = report["config"]["y_period"]
    with h5py.File(tables) as file:
        particles = {key: file["particles"][key][:] for key in ("x", "y", "z", "radius")}
    np.testing.assert_allclose(particles["x"], file_particles[:, 0], rtol=1e-12, atol=1e-18)
    turns = (particles["y"] - file_particles[:, 1]) / period
    np.testing.assert_allclose(turns, np.round(turns), atol=1e-9)
    np.testing.assert_allclose(particles["z"], file_particles[:, 2], rtol=1e-12)
    np.testing.assert_allclose(particles["radius"], file_particles[:, 3], rtol=1e-12)


def test_schema_holds_for_the_configurations(root):
    schema = json.loads((root / "config/schema/analysis.schema.json").read_text())
    shipped = yaml.safe_load((root / "config/analysis.yaml").read_text())
    validator = jsonschema.Draft202012Validator(schema)
    validator.check_schema(schema)
    for config in [shipped, *(json.loads(file.read_text()) for file in CASES.glob("*.cfg.json"))]:
        assert [error.message for error in validator.iter_errors(config)] == []
    for wrong in ({"gird": 1}, {"grid": "1 kg"}, {"x_range": [1]}, {"voxels_per_dp": [2.5]}, {"contact_mode": "sum"}):
        assert not validator.is_valid(wrong), wrong


@pytest.fixture(scope="module")
def report_schema(root):
    schema = json.loads((root / "config/schema/report.schema.json").read_text())
    jsonschema.Draft202012Validator.check_schema(schema)
    return jsonschema.Draft202012Validator(schema)


def test_schema_of_the_report(case, report_schema):
    _, _, report, _ = case
    assert [error.message[:300] for error in report_schema.iter_errors(report)] == []
    assert report_schema.is_valid({"steps": [{"step": 3, **report}]})
    wrong = [{**report, "more": 1}, {k: v for k, v in report.items() if k != "height"}, {"steps": [report]}]
    wrong += [{**report, "height": {**report["height"], "Ra": "0.1"}}, {**report, "uncertainty": {**report["uncertainty"], "height": 3}}]
    assert not any(map(report_schema.is_valid, wrong))


def test_schema_and_documentation_name_the_same_keys(root):
    schema = json.loads((root / "config/schema/analysis.schema.json").read_text())["properties"]
    lines = (root / "config/analysis.yaml").read_text().splitlines()
    named = {line.removeprefix("# ").split(":")[0] for line in lines if ": " in line or line.endswith(":")}
    assert set(schema) <= named
    reported = json.loads((CASES / "empty.json").read_text())["config"]
    assert set(reported) <= set(schema)
