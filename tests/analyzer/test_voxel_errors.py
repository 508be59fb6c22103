"""Errors of the voxel forms (voxel minus exact) on random layers, against the table of errors of the definitions.

The layers of tests/data/cases are of the kinds that the table is a range over: they must be in it, to half a unit of its last
digit. Other layers, made here, are of another kind (denser, up to two layers high): their mean, of either sign, may exceed the
larger end of the range by a quarter.
"""

import json
import subprocess
from pathlib import Path

import h5py
import numpy as np
import pytest

ROOT = Path(__file__).resolve().parents[2]
CASES = ROOT / "tests/data/cases"
LAYERS = ["clustered_sparse", "chains", "polydisperse"]
MADE = range(1, 7)
MARGIN = 1.25
# Lowest and highest error, and half a unit of the last digit: packing density of a node (largest, rms), its median over the layer
# and its spread IQR/median, mean height, roughness Ra, share of empty nodes, share of nodes empty in one form only.
TABLE = {
    4: {
        "phi_max": (0, 0.031, 5e-4),
        "phi_rms": (0, 0.009, 5e-4),
        "phi_median": (0, 0.007, 5e-4),
        "phi_spread": (-0.014, 0.020, 5e-4),
        "height_mean": (-0.19, 0, 5e-3),
        "Ra": (0, 0.11, 5e-3),
        "empty": (0, 0.12, 5e-3),
        "wrongly_empty": (0, 0.12, 5e-3),
    },
    10: {
        "phi_max": (0, 0.004, 5e-4),
        "phi_rms": (0, 0.0014, 5e-5),
        "phi_median": (-0.0002, 0.0011, 5e-5),
        "phi_spread": (-0.008, 0.010, 5e-4),
        "height_mean": (-0.07, 0, 5e-3),
        "Ra": (0, 0.035, 5e-4),
        "empty": (0, 0.04, 5e-3),
        "wrongly_empty": (0, 0.04, 5e-3),
    },
    20: {
        "phi_max": (0, 0.0012, 5e-5),
        "phi_rms": (0, 0.0004, 5e-5),
        "phi_median": (0, 0.0003, 5e-5),
        "phi_spread": (-0.0005, 0.004, 5e-4),
        "height_mean": (-0.036, 0, 5e-4),
        "Ra": (-0.006, 0.014, 5e-4),
        "empty": (0, 0.017, 5e-4),
        "wrongly_empty": (0, 0.017, 5e-4),
    },
    40: {
        "phi_max": (0, 0.0004, 5e-5),
        "phi_rms": (0, 0.0001, 5e-6),
        "phi_median": (-0.0001, 0.0001, 5e-5),
        "phi_spread": (-0.0006, 0.0006, 5e-5),
        "height_mean": (-0.017, 0, 5e-4),
        "Ra": (-0.005, 0.008, 5e-4),
        "empty": (0, 0.008, 5e-4),
        "wrongly_empty": (0, 0.008, 5e-4),
    },
}
# Chambers in pixels by rule P, D >= 0.5 d_p: highest share missed (to 0.005) and spurious, bias and standard deviation of the
# diameter (to 0.0005), which are means over some layers.
CHAMBERS = {
    10: {"missed": 0.14, "spurious": 0.24, "bias": 0.016, "deviation": 0.034},
    20: {"missed": 0.08, "spurious": 0.17, "bias": 0.002, "deviation": 0.016},
    40: {"missed": 0.03, "spurious": 0.11, "bias": -0.001, "deviation": 0.008},
}


def measured(build, folder, layer, *settings):
    """JSON report, and the maps of heights by resolution."""
    command = [build / "analyzer/recoat-analyze", "metrics", layer, "--quiet", "--json", folder / "out.json", "--out", folder / "out.h5"]
    for setting in ("voxels_per_dp=[4, 10, 20, 40]", "bootstrap_resamples=0", *settings):
        command += ["--set", setting]
    config = layer.with_suffix(".cfg.json")
    command += ["--config", config if config.exists() else ROOT / "bench/data/random-layer.yaml"]
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
    with h5py.File(folder / "out.h5") as file:
        heights = {n: file[f"voxel/{n}/height"][:] for n in TABLE}
        heights["exact"] = file["maps/height"][:]
    return json.loads((folder / "out.json").read_text()), heights


def map_errors(report, n):
    values, heights = report
    voxel, exact = values["voxel"][str(n)], heights["exact"]
    return {
        "phi_max": voxel["phi_max_error"],
        "phi_rms": voxel["phi_rms_error"],
        "phi_median": voxel["phi"]["median"] - values["phi_exact"]["median"],
        "phi_spread": voxel["phi"]["iqr_over_median"] - values["phi_exact"]["iqr_over_median"],
        "height_mean": np.mean(heights[n] - exact),
        "Ra": voxel["height"]["Ra"] - values["height"]["Ra"],
        "empty": voxel["height"]["empty_fraction"] - values["height"]["empty_fraction"],
        "wrongly_empty": np.mean((heights[n] == 0) != (exact == 0)),
    }


def chamber_errors(report, n):
    """None where there are none to be compared."""
    values, _ = report
    errors = values["voxel"][str(n)].get("chamber_P_errors")
    exact = [d for d in values["chamber_pores"].get("P", {}).get("sorted_sizes", []) if d >= 0.5]
    if not exact:
        assert errors is None
        return None
    pixels = [d for d in values["voxel"][str(n)]["chamber_P"]["sorted_sizes"] if d >= 0.5]
    assert errors["matched"] + errors["missed"] == len(exact)
    assert errors["matched"] + errors["spurious"] == len(pixels)
    return {
        "matched": errors["matched"],
        "missed": errors["missed"] / len(exact),
        "spurious": errors["spurious"] / len(pixels),
        "bias": errors["diameter_bias"],
        "deviation": errors["diameter_deviation"],
    }


def beyond(found, table):
    return {key: found[key] for key, (low, high, digit) in table.items() if not low - digit <= found[key] <= high + digit}


@pytest.fixture(scope="module", params=LAYERS)
def report(request, build, tmp_path_factory):
    return measured(build, tmp_path_factory.mktemp(request.param), CASES / f"{request.param}.csv")


@pytest.fixture(scope="module")
def made(build, tmp_path_factory):
    """Reports of random layers of 60 x 20 d_p."""
    reports = []
    for seed in MADE:
        folder = tmp_path_factory.mktemp(f"made{seed}")
        size = ["--particles", "768", "--length", "60", "--width", "20"]
        subprocess.run([build / "bench/random-layer", folder / "layer.csv", *size, "--seed", str(seed)], check=True)
        reports.append(measured(build, folder, folder / "layer.csv", "y_period=20 dp", "x_range=[3 dp, 57 dp]"))
    return reports


@pytest.mark.parametrize("n", TABLE)
def test_maps(report, n):
    found = map_errors(report, n)
    assert beyond(found, TABLE[n]) == {}
    assert found["height_mean"] < 0


@pytest.mark.parametrize("n", TABLE)
def test_maps_of_made_layers(made, n):
    errors = [map_errors(one, n) for one in made]
    limits = {key: (-MARGIN * max(-low, high), MARGIN * max(-low, high), digit) for key, (low, high, digit) in TABLE[n].items()}
    assert beyond({key: np.mean([one[key] for one in errors]) for key in limits}, limits) == {}


def test_limits_are_not_idle(report):
    """Each resolution exceeds what the next finer one is held to: a form that is too coarse by a factor of two would be seen."""
    for coarse, fine in ((4, 10), (10, 20), (20, 40)):
        assert beyond(map_errors(report, coarse), TABLE[fine]) != {}


@pytest.mark.parametrize("n", CHAMBERS)
def test_chambers(report, n):
    found, table = chamber_errors(report, n), CHAMBERS[n]
    if found is None:
        return
    assert found["missed"] <= table["missed"] + 0.005
    assert found["spurious"] <= table["spurious"] + 0.005
    # Bias and deviation of one layer scatter about those of its kind by their standard errors: over a dozen made layers of some
    # 340 circles the bias at n = 40 is -0.0009 with a scatter of 0.00045 = 0.008/sqrt(340). A program of its own (distance
    # transform of scipy, merge tree of pixels) finds -0.0037 for clustered_sparse too, three standard errors from the table.
    assert abs(found["bias"] - table["bias"]) <= 0.0005 + 3 * table["deviation"] / found["matched"] ** 0.5
    assert found["deviation"] <= 0.0005 + table["deviation"] * (1 + 3 / (2 * found["matched"]) ** 0.5)


@pytest.mark.parametrize("n", CHAMBERS)
def test_chambers_of_made_layers(made, n):
    errors = [chamber_errors(one, n) for one in made]
    found = {key: np.mean([one[key] for one in errors]) for key in errors[0]}
    assert found["missed"] <= CHAMBERS[n]["missed"] + 0.005
    assert found["spurious"] <= CHAMBERS[n]["spurious"] + 0.005
    # In pixel sides: the bias of these layers is 0.21, 0.07 and -0.04.
    assert abs(found["bias"] - CHAMBERS[n]["bias"]) * n <= 0.06
    assert found["deviation"] <= MARGIN * CHAMBERS[n]["deviation"]


@pytest.mark.parametrize("n", TABLE)
def test_density_pores(report, n):
    values, _ = report
    errors = values["voxel"][str(n)]["density_pore_errors_8"]
    assert errors["matched"] + errors["missed"] == values["density_pores"]["8"]["count"]
    assert errors["matched"] + errors["spurious"] == len(values["voxel"][str(n)]["density_pore_cells_8"])
    if n >= 20:
        assert errors["missed"] + errors["spurious"] <= 2
        assert abs(errors["diameter_bias"] or 0) < 0.1
