"""The smoke grid with the real programs, from scene to report."""

import json
import os
import re
import signal
import subprocess
import sys
import time

import pandas
import pytest


def test_smoke_grid(workflow, build):
    code, output = workflow("--configfile", "config/smoke.yaml", build=build)
    assert code == 0, output
    results = workflow.folder / "results/smoke"
    assert len(list((results / "figures").glob("*.png"))) == 17
    assert (results / "report.html").read_text().count("data:image/png;base64,") == 17

    table = pandas.read_csv(results / "tables/metrics.csv")
    assert len(table) == 4 and (table["particles"] > 10).all()
    shares = table[[f"coordination_{number}" for number in range(6)]].sum(axis=1)
    assert (shares <= 1 + 1e-6).all() and (shares > 0.9).all()
    for path in results.glob("layers/*/summary.json"):
        summary = json.loads(path.read_text())
        assert [stage["name"] for stage in summary["stages"]] == ["fill", "heap", "spread"]

    code, output = workflow("--configfile", "config/smoke.yaml", build=build)
    assert code == 0 and "Nothing to be done" in output


@pytest.mark.parametrize("grid", ["reduced", "smoke", "paper"])
def test_solver_accepts_every_scene_of_the_grid(workflow, build, grid):
    options = ("--dry-run", "--printshellcmds", "--configfile", f"config/{grid}.yaml")
    code, output = workflow(*options, build=build)
    commands = re.findall(r"(\S*recoat-solve run .*?) --out \S+ --overwrite --threads \d+ (.*?) > ", output)
    assert code == 0 and len(commands) >= 4, output
    for program, settings in commands:
        process = subprocess.run(
            f"{program} --print-config {settings}", shell=True, cwd=workflow.folder, capture_output=True, text=True
        )
        assert process.returncode == 0, process.stderr


def test_an_interrupted_case_continues_where_it_was(workflow, build):
    """Ctrl-C during a stage: the next call goes on from there and does not begin again."""
    folder = "results/smoke/layers/bond-5_ratio-0.01_seed-1"
    log = workflow.folder / folder / "solve.log"
    command = [sys.executable, "-m", "snakemake", "--cores", "1", f"{folder}/summary.json"]
    command += ["--configfile", "config/smoke.yaml", "--config", f"build_directory={build}"]
    process = subprocess.Popen(
        command, cwd=workflow.folder, start_new_session=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL
    )
    for _ in range(600):
        time.sleep(0.1)
        if log.exists() and "fill: " in log.read_text():
            break
    os.killpg(process.pid, signal.SIGINT)
    assert process.wait(timeout=60) != 0
    stopped = int(re.search(r"^Stopped at step (\d+)", log.read_text(), re.MULTILINE).group(1))
    assert stopped > 0 and not (workflow.folder / folder / "summary.json").exists()

    code, output = workflow(f"{folder}/summary.json", "--configfile", "config/smoke.yaml", build=build)
    assert code == 0, output
    assert f"Continuing at step {stopped}." in log.read_text()
    summary = json.loads((workflow.folder / folder / "summary.json").read_text())
    assert summary["status"] == "finished"
    assert sum(stage["steps"] for stage in summary["stages"]) > stopped
