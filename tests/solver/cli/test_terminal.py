"""What a run says while it goes on and when it ends."""

import re

import h5py
import pytest

from terminal import on_terminal

LONG = ("--set", "stages.fill.settle_time=5 ms", "--set", "stages.fill.settle_energy=1e-30", "--set", "time_step=2e-8 s")


@pytest.mark.parametrize("columns", [60, 20])
def test_a_narrow_terminal_gets_one_line_that_is_rewritten(solver, columns):
    command = [str(solver.program), "run", "spread.yaml", "--out", "out", "--threads", "1", *LONG]
    code, text = on_terminal(command, solver.folder, columns)
    assert code == 0, text
    rewritten = [line for part in text.split("\n") for line in part.split("\r\x1b[K")[1:-1]]
    assert rewritten and all(len(line) < columns for line in rewritten), rewritten
    assert all(re.search(r"\d %", line) for line in rewritten), rewritten
    if columns == 60:
        assert any(re.search(r"run: at most [0-9.]+ (s|ms|min) left", line) for line in rewritten), rewritten


def test_the_end_says_what_was_made_and_what_is_next(solver):
    text = solver("run", "spread.yaml", "--out", "my out", "--threads", 1).stderr
    assert re.search(r"^fill: [0-9 ]+ steps \([0-9.]+ ms\), not at rest yet when its settle_time was over\.$", text, re.M), text
    assert "In my out: fill.vtkhdf, heap.vtkhdf and spread.vtkhdf" in text
    assert re.search(r"trajectory.vtkhdf \(\d+ states\), walls.vtkhdf, energy.csv and summary.json", text)
    assert "Not at rest when the settle_time was over: fill" in text
    assert text.endswith('Next: recoat-analyze metrics "my out/spread.vtkhdf"\n')


def test_a_stage_that_settles_says_so(solver):
    text = solver("run", "spread.yaml", "--out", "out", "--threads", 1, "--set", "stages.fill.settle_energy=1e9").stderr
    assert re.search(r"^fill: .* settled\.$", text, re.M), text
    assert "Note: in the stage fill particles count as at rest while they still move at" in text


def test_the_command_to_continue_can_be_copied(solver):
    text = solver("run", "spread.yaml", "--out", "my out", "--threads", 1, "--until-step", 10).stderr
    assert text == 'Stopped at step 10; continue with: recoat-solve resume "my out"\n'


@pytest.mark.parametrize("command", [["resume", "out"], ["run", "spread.yaml", "--out", "out"]])
@pytest.mark.parametrize("gone", [["spread.vtkhdf"], ["walls.vtkhdf"], ["energy.csv"], ["spread.vtkhdf", "walls.vtkhdf", "energy.csv"]])
def test_deleted_files_of_the_end_are_made_again(solver, gone, command):
    solver.good("run", "spread.yaml", "--out", "out", "--threads", 1, "--quiet")

    def numbers(name):
        if name.endswith(".csv"):
            return (solver.folder / "out" / name).read_bytes()
        with h5py.File(solver.folder / "out" / name) as file:
            arrays = {}
            file.visititems(lambda place, item: arrays.update({place: item[()].tobytes()} if isinstance(item, h5py.Dataset) else {}))
            assert "VTKHDF/Points" in arrays
            return arrays

    before = {name: numbers(name) for name in gone}
    for name in gone:
        (solver.folder / "out" / name).unlink()
    text = solver(*command, "--threads", 1).stderr
    named = gone[0] if len(gone) == 1 else "spread.vtkhdf, walls.vtkhdf and energy.csv"
    assert text.startswith(f"{named} {'was' if len(gone) == 1 else 'were'} gone; "), text
    assert "made again from the checkpoint.\nFinished." in text, text
    assert {name: numbers(name) for name in gone} == before
    assert "this run is finished already; nothing to do" in solver(*command, "--threads", 1).stderr
    (solver.folder / "out/heap.vtkhdf").unlink()
    assert "heap.vtkhdf is gone" in solver.refusal("resume", "out")


def test_another_configuration_is_named_with_its_values(solver):
    solver.good("run", "spread.yaml", "--out", "out", "--threads", 1, "--quiet", "--until-step", 10)
    sentence = solver.refusal("run", "spread.yaml", "--out", "out", "--set", "box.width=5 dp")
    assert "another configuration (box.width is 4 dp there and 5 dp here)" in sentence


def test_what_a_table_lacks_is_said_once(solver):
    solver.write("table.csv", "x,y,z,radius,mass\n0,0,26e-6,25e-6,1")
    for command in (["check", "particles.yaml"], ["run", "particles.yaml", "--out", "out"]):
        done = solver(*command, "--threads", 1)
        assert done.returncode == 0, done.stderr
        warnings = [line for line in done.stderr.splitlines() if "warning" in line]
        assert len(warnings) == 2 and len(set(warnings)) == 2, warnings


@pytest.mark.parametrize("clearance", ["0 dp", "0 um", "-1 dp"])
def test_a_clearance_that_nothing_can_pass(solver, clearance):
    sentence = solver.refusal("check", "spread.yaml", "--set", f"blade.clearance={clearance}")
    assert "blade.clearance: no particle can pass under a blade with a clearance of" in sentence
