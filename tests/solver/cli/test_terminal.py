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
    assert re.search(r"trajectory.vtkhdf \(\d+ states\), energy.csv and summary.json", text)
    assert "Not at rest when the settle_time was over: fill" in text
    assert text.endswith('Next: recoat-analyze metrics "my out/spread.vtkhdf"\n')


def test_a_stage_that_settles_says_so(solver):
    text = solver("run", "spread.yaml", "--out", "out", "--threads", 1, "--set", "stages.fill.settle_energy=1e9").stderr
    assert re.search(r"^fill: .* settled\.$", text, re.M), text
    assert "Note: in the stage fill particles count as at rest while they still move at" in text


def test_the_command_to_continue_can_be_copied(solver):
    text = solver("run", "spread.yaml", "--out", "my out", "--threads", 1, "--until-step", 10).stderr
    assert text == 'Stopped at step 10; continue with: recoat-solve resume "my out"\n'


def test_a_deleted_last_state_is_made_again(solver):
    solver.good("run", "spread.yaml", "--out", "out", "--threads", 1, "--quiet")
    state = solver.folder / "out/spread.vtkhdf"

    def numbers():
        with h5py.File(state) as file:
            data = file["VTKHDF"]
            return [data["Points"][()].tobytes(), *(data["PointData"][name][()].tobytes() for name in sorted(data["PointData"]))]

    before = numbers()
    state.unlink()
    text = solver("resume", "out", "--threads", 1).stderr
    assert "spread.vtkhdf was gone; it is made again from the checkpoint" in text
    assert numbers() == before
    (solver.folder / "out/heap.vtkhdf").unlink()
    assert "heap.vtkhdf is gone" in solver.refusal("resume", "out")


def test_another_configuration_is_named_with_its_values(solver):
    solver.good("run", "spread.yaml", "--out", "out", "--threads", 1, "--quiet", "--until-step", 10)
    sentence = solver.refusal("run", "spread.yaml", "--out", "out", "--set", "box.width=5 dp")
    assert "another configuration (box.width is 4 dp there and 5 dp here)" in sentence
