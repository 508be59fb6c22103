"""Intervals of the program against the same resamples written out with numpy."""

import json
import subprocess
from pathlib import Path

import h5py
import numpy as np
import pytest

CASES = Path(__file__).resolve().parents[1] / "data/cases"
LAYERS = ["clustered_sparse", "polydisperse", "chains"]
RESAMPLES, BLOCK, SEED = 300, 3, 12345


def split_mix(seed, count):
    """The first outputs of SplitMix64."""
    mask = (1 << 64) - 1
    for index in range(1, count + 1):
        z = (seed + index * 0x9E3779B97F4A7C15) & mask
        z = ((z ^ (z >> 30)) * 0xBF58476D1CE4E5B9) & mask
        z = ((z ^ (z >> 27)) * 0x94D049BB133111EB) & mask
        yield z ^ (z >> 31)


def resampled_columns(columns):
    """Columns of each resample, with repetition."""
    block = min(BLOCK, max(columns // 4, 1))
    blocks = -(-columns // block)
    starts = [((number >> 32) * columns) >> 32 for number in split_mix(SEED, RESAMPLES * blocks)]
    rows = (np.reshape(starts, (RESAMPLES, blocks, 1)) + np.arange(block)) % columns
    return rows.reshape(RESAMPLES, -1)[:, :columns]


@pytest.fixture(scope="module", params=LAYERS)
def report(request, build, tmp_path_factory):
    """Report of a case, its particles' columns, and the columns of the resamples."""
    folder = tmp_path_factory.mktemp(request.param)
    command = [build / "analyzer/recoat-analyze", "metrics", CASES / f"{request.param}.csv"]
    command += ["--config", CASES / f"{request.param}.cfg.json", "--json", folder / "out.json", "--out", folder / "out.h5", "--quiet"]
    for setting in (f"bootstrap_block={BLOCK}", f"bootstrap_resamples={RESAMPLES}", f"bootstrap_seed={SEED}", "voxels_per_dp=[]"):
        command += ["--set", setting]
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
    found = json.loads((folder / "out.json").read_text())
    with h5py.File(folder / "out.h5") as file:
        inside = file["particles/in_region"][:] == 1
        found["x"] = (file["particles/x"][:] - found["config"]["x_range"][0]) / found["config"]["d_p"]
        found["z"] = file["particles/z"][:] / found["config"]["d_p"]
    found["inside"] = inside
    found["tables"] = folder / "out.h5"
    return found


def check(estimate, resampled):
    """The interval is that of these resampled values."""
    resampled = np.asarray(resampled, dtype=float)
    defined = resampled[np.isfinite(resampled)]
    lower, upper = np.percentile(defined, [2.5, 97.5])
    assert estimate["lower"] == pytest.approx(lower, rel=1e-9, abs=1e-12)
    assert estimate["upper"] == pytest.approx(upper, rel=1e-9, abs=1e-12)
    assert estimate["standard_error"] == pytest.approx(defined.std(ddof=1), rel=1e-9, abs=1e-12)


def test_maps(report):
    uncertainty = report["uncertainty"]
    phi, height = (np.array(report["maps"][name]) for name in ("phi_exact", "height"))
    resamples = resampled_columns(len(height))
    assert uncertainty["block_columns"] == min(BLOCK, len(height) // 4)

    def relative_iqr(values):
        lower, median, upper = np.percentile(values, [25, 50, 75])
        return (upper - lower) / median if median != 0 else np.nan

    check(uncertainty["phi_exact"]["median"], [np.median(phi[r]) for r in resamples])
    check(uncertainty["phi_exact"]["mean"], [phi[r].mean() for r in resamples])
    check(uncertainty["phi_exact"]["iqr_over_median"], [relative_iqr(phi[r]) for r in resamples])
    check(uncertainty["height"]["Ra"], [np.abs(height[r] - height[r].mean()).mean() for r in resamples])
    check(uncertainty["height"]["empty_fraction"], [(height[r] == 0).mean() for r in resamples])
    check(uncertainty["density_pores"]["8"]["area_fraction"], [(phi[r] < 0.1).mean() for r in resamples])
    fractions = uncertainty["height"]["fraction"]
    for number, edge in enumerate(fractions["items"]):
        shares = [((height[r] > edge - 0.25 + 2.5e-7) & (height[r] <= edge + 2.5e-7)).mean() for r in resamples]
        check({key: fractions[key][number] for key in ("lower", "upper", "standard_error")}, shares)


def test_particles(report):
    uncertainty = report["uncertainty"]
    columns = uncertainty["columns"]
    inside = report["inside"]
    column = np.floor(report["x"][inside] + 1e-6).astype(int)
    contacts, size = (np.array(report["particles"][name])[inside] for name in ("cn", "cluster_size"))
    members = [np.flatnonzero(column == c) for c in range(columns)]
    chosen = [np.concatenate([members[c] for c in r]) for r in resampled_columns(columns)]
    check(uncertainty["clusters"]["cn_mean"], [contacts[r].mean() for r in chosen])
    check(uncertainty["vertical"]["mean"], [report["z"][inside][r].mean() for r in chosen])
    classes = uncertainty["clusters"]["size_class_fraction"]
    bounds = [*classes["items"], np.inf]
    for number in range(len(classes["items"])):
        shares = [((size[r] >= bounds[number]) & (size[r] < bounds[number + 1])).mean() for r in chosen]
        check({key: classes[key][number] for key in ("lower", "upper", "standard_error")}, shares)


@pytest.mark.parametrize("kind", ["density_pores/4", "density_pores/8", "chamber_pores/A"])
def test_pores(report, kind):
    group, name = kind.split("/")
    pores = report[group][name]
    if group == "density_pores":
        x, diameter = (np.array([pore[key] for pore in pores["pores"]]) for key in ("x", "diameter"))
    else:
        x, _, diameter = np.array(pores["circles_x_y_d"]).T
    estimates = report["uncertainty"][group][name]
    columns = report["uncertainty"]["columns"]
    column = np.clip(np.floor(x + 1e-6).astype(int), 0, columns - 1)
    members = [diameter[column == c] for c in range(columns)]
    chosen = [np.concatenate([members[c] for c in r]) for r in resampled_columns(columns)]
    check(estimates["count"], [len(r) for r in chosen])
    if len(diameter) < 5:
        assert estimates["median"]["value"] == pores["median"] and estimates["median"]["lower"] is None
        return
    check(estimates["median"], [np.median(r) if len(r) else np.nan for r in chosen])
    check(estimates["mean"], [r.mean() if len(r) else np.nan for r in chosen])
    small = estimates["group_number_fraction"]
    first = {key: small[key][1] for key in ("lower", "upper", "standard_error")}
    check(first, [((r >= 1 - 1e-6) & (r < 2 - 1e-6)).mean() if len(r) else np.nan for r in chosen])


def test_hdf5_holds_the_same_intervals(report):
    with h5py.File(report["tables"]) as file:
        group = file["uncertainty"]
        assert group.attrs["seed"] == SEED and group.attrs["resamples"] == RESAMPLES
        median = report["uncertainty"]["phi_exact"]["median"]
        assert {key: group[f"phi_exact/median/{key}"][0] for key in median} == median
        fractions = report["uncertainty"]["chamber_pores"]["A"]["group_number_fraction"]
        assert group["chamber_pores/A/group_number_fraction/upper"][:].tolist() == fractions["upper"]
        assert group["height/Ra/lower"].attrs["unit"] == b"d_p"


def test_numbers_of_pores_on_the_map(report):
    for connectivity in ("4", "8"):
        numbers = np.array(report["maps"][f"density_pore_{connectivity}"])
        cells = [pore["cells"] for pore in report["density_pores"][connectivity]["pores"]]
        assert np.bincount(numbers.ravel(), minlength=len(cells) + 1)[1:].tolist() == cells
        np.testing.assert_array_equal(numbers > 0, np.array(report["maps"]["phi_exact"]) < 0.1)
