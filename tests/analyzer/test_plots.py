"""Figures that the program draws with the workflow's scripts."""

import os
import subprocess
import sys
from pathlib import Path

import pytest

CASES = Path(__file__).resolve().parents[1] / "data/cases"


@pytest.fixture
def plot(build, root, tmp_path):
    def call(*arguments, **environment):
        command = [build / "analyzer/recoat-analyze", "metrics", CASES / "polydisperse.csv", "--config", CASES / "polydisperse.cfg.json"]
        command += ["--quiet", "--plots", tmp_path / "figures", *arguments]
        defaults = {"RECOAT_PYTHON": sys.executable, "RECOAT_SCRIPTS": str(root / "workflow/scripts")}
        return subprocess.run(command, capture_output=True, text=True, check=False, env={**os.environ, **defaults, **environment})

    return call


def test_standard_figures(plot, tmp_path):
    done = plot("--set", "base=-5 um", "--set", "bootstrap_resamples=0")
    assert done.returncode == 0, done.stderr
    files = sorted(file.name for file in (tmp_path / "figures").iterdir())
    assert len(files) == 22
    assert {Path(name).stem for name in files} == {
        "layer_from_above", "height_map", "coordination_number", "vertical_distribution", "clusters_from_above", "cluster_size",
        "cluster_orientation", "surface_height", "pores_from_above", "pore_size_distribution", "pore_size_groups",
    }  # fmt: skip
    for name in files:
        begin = (tmp_path / "figures" / name).read_bytes()[:5]
        assert begin == (b"%PDF-" if name.endswith("pdf") else b"\x89PNG\r")


@pytest.mark.parametrize(
    "environment, sentence",
    [
        ({"RECOAT_PYTHON": "/nowhere/python"}, 'the Python "/nowhere/python" cannot be started; run ./setup.sh'),
        ({"RECOAT_SCRIPTS": "/nowhere"}, "/nowhere/plot_layer.py is not there; set RECOAT_SCRIPTS"),
        ({"PYTHONPATH": "broken"}, "has no package numpy; run ./setup.sh"),
    ],
)
def test_one_sentence_where_figures_cannot_be_drawn(plot, tmp_path, environment, sentence):
    if environment.get("PYTHONPATH"):
        broken = tmp_path / "broken/numpy"
        broken.mkdir(parents=True)
        (broken / "__init__.py").write_text("raise ImportError('no', name='numpy')\n")
        environment = {"PYTHONPATH": str(tmp_path / "broken")}
    done = plot(**environment)
    assert done.returncode == 2
    assert sentence in done.stderr and len(done.stderr.splitlines()) == 1
    assert not (tmp_path / "figures").exists()
