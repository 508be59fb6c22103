"""Sweeps from the command line."""

import os
import shutil
import signal
import subprocess
import time

import pytest
from test_runs import STATES, assert_same_particles, without_clock

SWEEP = """
scene: spread.yaml
cases:
  - {out: swept/a, set: [cohesion.bond_number=5]}
  - {out: swept/b, set: [cohesion.bond_number=50, seed=4]}
"""


def test_a_sweep_gives_the_files_of_single_runs(solver):
    solver.write("sweep.yaml", SWEEP)
    report = solver.good("sweep", "sweep.yaml", "--jobs", 2, "--threads", 1, "--backend", "cpu", "--quiet")
    assert report == "swept/a: finished\nswept/b: finished\n"
    for name, settings in {"a": ["cohesion.bond_number=5"], "b": ["cohesion.bond_number=50", "seed=4"]}.items():
        options = [text for setting in settings for text in ("--set", setting)]
        solver.good("run", "spread.yaml", "--out", f"single/{name}", "--threads", 1, "--backend", "cpu", "--quiet", *options)
        swept, single = (solver.folder / kind / name for kind in ("swept", "single"))
        assert sorted(file.name for file in swept.iterdir()) == sorted(file.name for file in single.iterdir())
        for file in (*STATES, "trajectory.vtkhdf", "energy.csv"):
            assert (swept / file).read_bytes() == (single / file).read_bytes(), file
        assert without_clock(solver.summary(swept)) == without_clock(solver.summary(single))
    again = solver.good("sweep", "sweep.yaml", "--quiet")
    assert again == "swept/a: already finished\nswept/b: already finished\n"


def test_lines_of_progress_name_their_case(solver):
    solver.write("sweep.yaml", SWEEP)
    lines = solver("sweep", "sweep.yaml").stderr.splitlines()
    assert {line.split(": ")[0] for line in lines} == {"swept/a", "swept/b"}
    for case in ("swept/a", "swept/b"):
        said = [line.split(": ")[1] for line in lines if line.startswith(case)]
        assert [word for word in said if word in ("fill", "heap", "spread")] == ["fill", "heap", "spread"]


def test_every_scene_is_checked_before_the_first_one_starts(solver):
    solver.write("sweep.yaml", SWEEP + "  - {out: swept/c, set: [time_step=1 s]}\n")
    assert "sweep.yaml:6: cases.2: --set time_step=1 s" in solver.refusal("sweep", "sweep.yaml")
    assert not (solver.folder / "swept").exists()


def test_the_example_is_good(solver, root):
    """All its scenes are, where only the one behind them is refused."""
    shutil.copytree(root / "config", solver.folder / "config")
    example = (root / "config/sweep.yaml").read_text()
    solver.write("config/sweep.yaml", example + "  - {out: last, set: [time_step=1 s]}\n")
    line = len(example.splitlines()) + 1
    assert f"config/sweep.yaml:{line}: cases.4: --set time_step=1 s" in solver.refusal("sweep", "config/sweep.yaml")


def test_a_case_that_cannot_run_does_not_stop_the_others(solver):
    solver.write("sweep.yaml", SWEEP)
    (solver.folder / "swept").mkdir()
    solver.write("swept/a", "a file")
    result = solver("sweep", "sweep.yaml", "--quiet")
    assert result.returncode == 2
    sentence = result.stderr.strip()
    assert sentence.startswith("swept/a: error: ") and len(sentence.splitlines()) == 1
    assert result.stdout.splitlines() == [sentence, "swept/b: finished"]


@pytest.mark.parametrize("number", [signal.SIGINT, signal.SIGTERM])
def test_a_signal_stops_all_and_the_same_command_goes_on(solver, number):
    solver.write("sweep.yaml", SWEEP.replace("seed=4", "seed=4, stages.spread.length=18 dp"))
    solver.good("sweep", "sweep.yaml", "--quiet")
    os.rename(solver.folder / "swept", solver.folder / "whole")
    command = [solver.program, "sweep", "sweep.yaml", "--jobs", "2", "--threads", "1"]
    process = subprocess.Popen(command, cwd=solver.folder, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
    while not (solver.folder / "swept/b/fill.vtkhdf").exists():
        time.sleep(0.01)
    process.send_signal(number)
    report = process.communicate(timeout=60)[0].splitlines()
    assert process.returncode == 128 + number
    assert report[1] == "swept/b: stopped with a checkpoint"
    assert solver.summary("swept/b")["status"] == "stopped"
    solver.good("sweep", "sweep.yaml", "--quiet")
    for case in ("a", "b"):
        assert solver.summary(f"swept/{case}")["status"] == "finished"
        assert_same_particles(solver.folder / "whole" / case, solver.folder / "swept" / case)
