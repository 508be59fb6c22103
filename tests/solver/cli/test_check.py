"""What `recoat-solve check` says of a scene before any time is spent on it."""

import json

import pytest


def notes(solver, *arguments):
    return json.loads(solver.good("check", *arguments, "--json", "--threads", 1))["notes"]


def test_nothing_is_said_of_a_usual_scene(solver, root):
    for scene in ("small_spread", "unequal_spread", "collision", "pull_off"):
        found = notes(solver, root / f"config/examples/{scene}.yaml", "--set", "output.trajectory_interval=0 s")
        assert found == [] or scene == "unequal_spread" and "largest particles do not pass" in found[0], found


@pytest.mark.parametrize(
    "setting, words",
    [
        ("stiffness_ratio=1e-9", "too soft"),
        ("blade.clearance=0.5 dp", "no particle passes under the blade"),
        ("blade.clearance=20 dp", "passes above the powder"),
        ("cohesion.bond_number=1e9", "too soft"),
        ("material.density=4430 g/cm3", "check the unit"),
    ],
)
def test_what_is_probably_not_meant_is_said(solver, setting, words):
    assert any(words in note for note in notes(solver, "spread.yaml", "--set", setting))
    assert f"Note: {notes(solver, 'spread.yaml', '--set', setting)[0]}." in solver.good("check", "spread.yaml", "--set", setting)


def test_sizes_far_from_the_diameter_are_said(solver):
    solver.write("table.csv", "x,y,z,radius,vx,vy,vz,wx,wy,wz\n0,0,25e-6,25e-6,0,0,0,0,0,0\n1e-3,0,2e-6,2e-6,0,0,0,0,0,0\n")
    assert any("measure 4 um to 50 um, far from" in note for note in notes(solver, "particles.yaml", "--set", "time_step=2e-8 s"))
    solver.write("table.csv", "x,y,z,radius,vx,vy,vz,wx,wy,wz\n0,0,25e-3,25e-3,0,0,0,0,0,0\n")
    assert any("measure 50 mm, far from" in note for note in notes(solver, "particles.yaml"))


def test_overlaps_at_the_start_are_said_with_their_energy(solver):
    """Hertz: 8/15 E* sqrt(R*) d^2.5 with E* = 60.44 MPa, R* = 12.5 um and d = 2 um."""
    solver.write("table.csv", "x,y,z,radius,vx,vy,vz,wx,wy,wz\n0,0,26e-6,25e-6,0,0,0,0,0,0\n48e-6,0,26e-6,25e-6,0,0,0,0,0,0\n")
    energy = 8 / 15 * 6.04395604e7 * 12.5e-6**0.5 * 2e-6**2.5
    (note,) = notes(solver, "particles.yaml")
    assert "particle 0 and particle 1 overlap at the start by 2 um (0.08 of the smallest radius)" in note
    assert f"{energy * 1e12:.4g} pJ" in note
    text = solver("run", "particles.yaml", "--out", "out", "--threads", 1).stderr
    assert f"Note: {note}." in text
    solver.write("table.csv", "x,y,z,radius,vx,vy,vz,wx,wy,wz\n0,0,25.01e-6,25e-6,0,0,0,0,0,0\n")
    assert notes(solver, "particles.yaml") == []


def test_output_is_foretold(solver):
    """The number of states, and their size within the room that deflating leaves."""
    settings = ("--set", "stages.fill.settle_energy=1e-30", "--set", "stages.heap.settle_energy=1e-30",
                "--set", "stages.spread.settle_energy=1e-30", "--set", "powder.particles=400", "--set", "box.fill_length=8 dp",
                "--set", "stages.fill.settle_time=0.2 ms", "--set", "stages.heap.settle_time=0.1 ms", "--set", "box.width=8 dp",
                "--set", "stages.spread.length=1 dp", "--set", "output.trajectory_interval=0.1 ms")
    expected = json.loads(solver.good("check", "spread.yaml", *settings, "--json"))["expected"]["output"]
    solver.good("run", "spread.yaml", *settings, "--out", "out", "--quiet", "--threads", 1)
    real = sum(file.stat().st_size for file in (solver.folder / "out").iterdir())
    assert 0.3 * expected["bytes"] < real < expected["bytes"] * 1.05, (real, expected)


def test_more_output_than_the_disk_has_is_said(solver):
    settings = ("--set", "output.trajectory_interval=1e-7 s", "--set", "stages.heap.settle_time=2000 s")
    (note,) = notes(solver, "spread.yaml", *settings)
    assert "20 000 " in note and "states of the trajectory" in note and "the disk has" in note
    text = solver("run", "spread.yaml", "--out", "out", "--until-step", 1, "--threads", 1, *settings).stderr
    assert f"Note: {note.split(',')[0]}"[:30] in text


def test_run_times_and_the_load_of_the_machine(solver):
    expected = json.loads(solver.good("check", "spread.yaml", "--json"))["expected"]
    # 7500 steps of lifting and 3000 of travel (1.5 and 6 dp at 100 mm/s) of 30 000 + 13 500 at most
    assert expected["seconds_without_settling"] / expected["seconds"] == pytest.approx((7500 + 30000) / (20000 + 10000 + 7500 + 30000 + 3000))
    assert 0 < expected["processor_share"] <= 1
    assert expected["busy"] == (expected["processor_share"] < 0.9)
    text = solver.good("check", "spread.yaml")
    assert "run time, while walls move and time is given" in text and "run time at most, if nothing settles early" in text


def test_units_are_those_of_a_person(solver):
    text = solver.good("check", "spread.yaml")
    for words in ("50 um", "289.9 ng", "60.44 GPa", "100 ns", "2 ms at most"):
        assert words in text, text


@pytest.mark.parametrize(
    "old, new, words",
    [
        ("length: 6 dp", "lenght: 6 dp", 'did you mean "length"?'),
        ("box: {length: 30 dp", "box: {lenght: 30 dp", 'box.lenght: the key is unknown; did you mean "length"?'),
        ("blade:", "balde:", 'balde: the key is unknown; did you mean "blade"?'),
        ("stages:", "stage:", 'stage: the key is unknown; did you mean "stages"?'),
        ("powder: {particles: 40}", "start_form: x.vtkhdf", 'start_form: the key is unknown; did you mean "start_from"?'),
        ("bond_number: 5", "bond_number: 5, cutoff: 1 um", 'cohesion.cutoff: the key is unknown; did you mean "cut_off"?'),
        ("stiffness_ratio: 0.001", "stifness_ratio: 0.001", 'stifness_ratio: the key is unknown; did you mean "stiffness_ratio"?'),
        ("gravity: 9.81 m/s2", "gravty: 9.81 m/s2", 'gravty: the key is unknown; did you mean "gravity"?'),
        ("  - heap: {settle_time: 1 ms}\n", "", "the gate stands in the way of the blade"),
        ("  - heap: {settle_time: 1 ms}", "  - move: {wall: base, velocity: [0 m/s, 0 m/s, -1 mm/s], duration: 1 ms}", '"base" may move along x and y only'),
    ],
)
def test_what_is_misspelt_or_cannot_work_is_refused(solver, old, new, words):
    text = (solver.folder / "spread.yaml").read_text()
    assert old in text
    solver.write("spread.yaml", text.replace(old, new))
    assert words in solver.refusal("check", "spread.yaml")


@pytest.mark.parametrize(
    "arguments, words",
    [
        (["rum", "spread.yaml"], 'did you mean "run"?'),
        (["check", "spread.yaml", "--threads", "0"], '"0" is no whole number from 1 to 1024'),
        (["check", "spread.yaml", "--thread", "1"], 'did you mean "--threads"?'),
        (["check", "spread.yaml", "other.yaml"], '"other.yaml" is one argument too many'),
        (["run", "spread.yaml", "--out", "out", "--until-step", "-1"], "whole number 0 or more"),
        (["sweep", "sweep.yaml", "--jobs", "many"], '"many" is no whole number'),
    ],
)
def test_the_command_line_says_what_is_wrong(solver, arguments, words):
    assert words in solver.refusal(*arguments)
