"""What the SLURM profile asks of a cluster; sbatch is a stand-in that notes how it was called and refuses."""

import json
import os
import re

import pytest
import yaml
from test_dag import change

PROFILE = ("--profile", "workflow/profiles/slurm")
CASE = "results/smoke/layers/bond-5_ratio-0.01_seed-1"
TARGET = f"{CASE}/spread.vtkhdf"


@pytest.fixture
def sbatch(workflow, tmp_path, monkeypatch):
    """The arguments of every call of sbatch."""
    folder, calls = tmp_path / "bin", tmp_path / "calls"
    folder.mkdir()
    for name in ("sbatch", "sinfo", "squeue", "sacct"):
        program = folder / name
        answer = {"sbatch": f'echo "$@" >>{calls}; exit 1', "sinfo": "echo main\\*"}.get(name, "exit 1")
        program.write_text(f"#!/bin/sh\n{answer}\n")
        program.chmod(0o755)
    monkeypatch.setenv("PATH", f"{folder}:{os.environ['PATH']}")

    def submit(doubles, target):
        code, output = workflow(target, *PROFILE, "--configfile", "config/smoke.yaml", "--retries", "0", build=doubles)
        assert code != 0 and calls.exists(), output
        return calls.read_text()

    return submit


def expect(workflow, case, hours):
    """Leave what recoat-solve check found for a case."""
    file = workflow.folder / case / "derived.json"
    file.parent.mkdir(parents=True)
    file.write_text(json.dumps({"expected": {"seconds": 3600 * hours}}))


@pytest.mark.parametrize("grid", ["smoke", "reduced", "paper"])
def test_every_grid_is_planned_as_the_readme_says(workflow, doubles, grid):
    code, output = workflow("--dry-run", "--quiet", "rules", *PROFILE, "--configfile", f"config/{grid}.yaml", build=doubles)
    assert code == 0 and "simulate_layer" in output, output


def test_the_programs_are_those_for_other_machines(workflow):
    profile = yaml.safe_load((workflow.folder / "workflow/profiles/slurm/config.yaml").read_text())
    assert profile["config"] == ["build_directory=build/portable/programs"] and profile["restart-times"] >= 3


@pytest.mark.parametrize("hours, asked", [(0.1, 19), (2, 190), (1000, 60 * 168)])
def test_the_run_time_follows_from_the_case(workflow, doubles, sbatch, hours, asked):
    expect(workflow, CASE, hours)
    call = sbatch(doubles, TARGET)
    assert re.search(rf" -t {asked} ", call) and "--mem 16000" in call, call


def test_the_grid_says_how_long_a_job_may_be(workflow, doubles, sbatch):
    change(workflow, "smoke", longest_job_hours=24)
    expect(workflow, CASE, 1000)
    assert " -t 1440 " in sbatch(doubles, TARGET)


def test_a_sweep_asks_for_the_time_of_all_its_cases_and_a_gpu(workflow, doubles, sbatch):
    change(workflow, "smoke", gpus=1)
    for bond in (5, 50):
        for ratio in (0.01, 0.001):
            expect(workflow, f"results/smoke/layers/bond-{bond}_ratio-{ratio}_seed-1", 1)
    call = sbatch(doubles, "results/smoke/sweeps/layers-1.txt")
    assert " -t 370 " in call and re.search(r"--gpus(-per-\w+)?[= ]1|gres=gpu:1", call), call
