"""The smoke grid with the real programs, from scene to report."""

import json
import re
import subprocess

import pandas
import pytest


def test_smoke_grid(workflow, build):
    code, output = workflow("--configfile", "config/smoke.yaml", build=build)
    assert code == 0, output
    results = workflow.folder / "results/smoke"
    assert len(list((results / "figures").glob("*.png"))) == 14
    assert (results / "report.html").read_text().count("data:image/png;base64,") == 14

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
