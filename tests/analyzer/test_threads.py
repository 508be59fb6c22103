"""One thread or two: the same bytes."""

import subprocess
from pathlib import Path

import pytest

CASES = Path(__file__).resolve().parents[1] / "data/cases"


@pytest.fixture(scope="module", params=["equal", "unequal"])
def layer(request, build, tmp_path_factory):
    """A layer large enough for many blocks and strips."""
    file = tmp_path_factory.mktemp("layer") / "layer.csv"
    radii = [] if request.param == "equal" else ["--spread", "0.2"]
    subprocess.run([build / "bench/random-layer", file, "--particles", "14000", "--length", "549", "--width", "40", *radii], check=True)
    return file


def test_reports_have_the_same_bytes(layer, build, tmp_path):
    results = []
    # Work is shared out differently in every run: once may agree by chance.
    for threads in (1, 2, 2, 2, 2, 2, 2):
        report, tables = tmp_path / "out.json", tmp_path / "out.h5"
        command = [build / "analyzer/recoat-analyze", "metrics", layer, "--threads", str(threads), "--quiet", "--json", report, "--out", tables]
        for setting in ("d_p=50 um", "density=4430", "h_b=75 um", "x_range=[0, 549 dp]", "y_min=0", "y_period=40 dp", "bootstrap_resamples=50"):
            command += ["--set", setting]
        done = subprocess.run(command, capture_output=True, text=True, check=False)
        assert done.returncode == 0, done.stderr
        results.append((report.read_bytes(), tables.read_bytes()))
    assert len(results[0][0]) > 100_000
    assert all(result == results[0] for result in results)
