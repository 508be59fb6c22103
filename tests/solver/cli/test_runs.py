"""Whole runs from the command line."""

import os
import signal
import subprocess
import time

import h5py
import numpy as np
import pytest

STATES = ("fill.vtkhdf", "heap.vtkhdf", "spread.vtkhdf")
POINT_DATA = ("Id", "Radius", "Velocity", "AngularVelocity", "CoordinationNumber")


def particle_bytes(file):
    """Everything that a state file says of the particles, as bytes."""
    with h5py.File(file) as state:
        data = state["VTKHDF"]
        assert sorted(data["PointData"]) == sorted(POINT_DATA)
        arrays = [data["Points"], *(data["PointData"][name] for name in POINT_DATA), data["Steps/Values"]]
        return [np.asarray(array).tobytes() for array in arrays]


def assert_same_particles(one, other):
    for name in (*STATES, "trajectory.vtkhdf"):
        assert particle_bytes(one / name) == particle_bytes(other / name), name


def without_clock(summary):
    clock = {"wall_seconds", "particle_steps_per_second", "threads"}
    summary = {key: value for key, value in summary.items() if key not in clock}
    summary["stages"] = [{k: v for k, v in stage.items() if k not in clock} for stage in summary["stages"]]
    return summary


def test_a_small_spread_ends_with_states_and_a_summary(solver):
    solver.good("run", "spread.yaml", "--out", "out", "--threads", 1, "--quiet")
    out = solver.folder / "out"
    assert sorted(f.name for f in out.iterdir()) == sorted(
        [*STATES, "trajectory.vtkhdf", "checkpoint.h5", "checkpoint-previous.h5", "energy.csv", "summary.json", "walls.vtkhdf"]
    )
    summary = solver.summary("out")
    assert summary["status"] == "finished"
    assert summary["particles"] == 40 and summary["particles_lost"] == 0
    assert [stage["name"] for stage in summary["stages"]] == ["fill", "heap", "spread"]
    assert summary["steps"] == sum(stage["steps"] for stage in summary["stages"])
    assert all(0 < stage["largest_overlap"] < 0.05 for stage in summary["stages"])
    spread = summary["stages"][2]
    assert spread["energy"]["wall_work"] > 0
    assert abs(spread["energy"]["balance_error_relative"]) < 0.01
    energy = np.genfromtxt(out / "energy.csv", delimiter=",", names=True)
    assert len(energy) == summary["steps"] // 5000 + 1
    assert energy["dissipated_normal_J"][-1] > 0


def test_particles_end_where_the_walls_let_them(solver):
    solver.good("run", "spread.yaml", "--out", "out", "--threads", 1, "--quiet")
    diameter = 50e-6
    slack = 0.01 * diameter
    with h5py.File(solver.folder / "out/fill.vtkhdf") as file:
        points = file["VTKHDF/Points"][()] / diameter
    assert np.all(points[:, 2] >= 0.5 - 0.01)
    assert np.all((points[:, 0] >= 4.5 - 0.01) & (points[:, 0] <= 7.5 + 0.01))
    with h5py.File(solver.folder / "out/spread.vtkhdf") as file:
        points = file["VTKHDF/Points"][()]
        attributes = dict(file["recoat"].attrs)
    assert np.all((points[:, 1] >= 0) & (points[:, 1] < 4 * diameter))
    assert np.all(points[:, 2] >= 0.5 * diameter - slack)
    behind = points[:, 0] < 6 * diameter
    assert np.all(points[behind, 2] <= 1.5 * diameter)
    assert attributes["diameter"] == pytest.approx(diameter)
    assert attributes["clearance"] == pytest.approx(1.5 * diameter)
    assert attributes["spread_length"] == pytest.approx(6 * diameter)


def test_one_and_two_threads_give_the_same_bytes(solver):
    for threads in (1, 2):
        solver.good("run", "spread.yaml", "--out", f"out{threads}", "--threads", threads, "--quiet")
    assert_same_particles(solver.folder / "out1", solver.folder / "out2")
    assert without_clock(solver.summary("out1")) == without_clock(solver.summary("out2"))


def test_loops_long_enough_for_two_threads_give_the_same_bytes(solver):
    """The engine keeps short loops on one thread; 4096 spheres that touch their neighbours are shared out."""
    grid = np.indices((16, 16, 16)).reshape(3, -1).T * 49.9e-6 + 30e-6
    speed = np.sin(np.arange(grid.size)).reshape(grid.shape) * 1e-3
    rows = np.column_stack([grid, np.full(len(grid), 25e-6), speed, np.zeros_like(speed)])
    names = "x,y,z,radius,vx,vy,vz,wx,wy,wz"
    np.savetxt(solver.folder / "table.csv", rows, delimiter=",", header=names, comments="")
    for threads in (1, 2):
        run = ("run", "particles.yaml", "--out", f"out{threads}", "--threads", threads, "--quiet")
        solver.good(*run, "--set", "duration=20 us")
    states = [sorted((solver.folder / f"out{threads}").glob("*.vtkhdf")) for threads in (1, 2)]
    assert states[0] and [f.name for f in states[0]] == [f.name for f in states[1]]
    for one, other in zip(*states):
        if one.name != "walls.vtkhdf":
            assert particle_bytes(one) == particle_bytes(other), one.name


def test_stopped_and_resumed_it_is_the_same_run_to_the_bit(solver):
    solver.good("run", "spread.yaml", "--out", "whole", "--threads", 1, "--quiet")
    steps = solver.summary("whole")["steps"]
    solver.good("run", "spread.yaml", "--out", "parts", "--threads", 1, "--quiet", "--until-step", steps // 3)
    assert solver.summary("parts")["status"] == "stopped"
    assert solver.summary("parts")["steps"] == steps // 3
    solver.good("resume", "parts", "--threads", 2, "--quiet", "--until-step", 2 * steps // 3 + 1)
    solver.good("resume", "parts", "--threads", 1, "--quiet")
    assert_same_particles(solver.folder / "whole", solver.folder / "parts")
    assert without_clock(solver.summary("parts")) == without_clock(solver.summary("whole"))
    assert (solver.folder / "parts/energy.csv").read_bytes() == (solver.folder / "whole/energy.csv").read_bytes()


def test_a_stage_starts_from_a_state_file(solver):
    solver.good("run", "spread.yaml", "--out", "out", "--quiet")
    text = (solver.folder / "spread.yaml").read_text()
    text = text.replace("powder: {particles: 40}", "start_from: out/fill.vtkhdf").replace(
        "  - fill: {settle_time: 2 ms}\n", ""
    )
    solver.write("from_fill.yaml", text)
    solver.good("run", "from_fill.yaml", "--out", "again", "--quiet")
    assert solver.summary("again")["particles"] == 40
    assert [stage["name"] for stage in solver.summary("again")["stages"]] == ["heap", "spread"]


def test_a_state_of_other_particles_is_refused(solver):
    solver.good("run", "particles.yaml", "--out", "out", "--quiet")
    text = (solver.folder / "particles.yaml").read_text()
    text = text.replace("particles: table.csv", "start_from: out/run.vtkhdf")
    solver.write("next.yaml", text.replace("diameter: 50 um", "diameter: 40 um"))
    assert "particle diameter" in solver.refusal("run", "next.yaml", "--out", "next")
    solver.write("next.yaml", text)
    solver.good("run", "next.yaml", "--out", "next", "--quiet")


@pytest.mark.parametrize("unknown", ["left out", "nan"])
def test_a_state_without_velocities_begins_at_rest(solver, unknown):
    """Files of other codes need not say how their particles move."""
    solver.good("run", "particles.yaml", "--out", "out", "--quiet")
    text = (solver.folder / "particles.yaml").read_text()
    solver.write("next.yaml", text.replace("particles: table.csv", "start_from: out/run.vtkhdf"))
    with h5py.File(solver.folder / "out/run.vtkhdf", "r+") as file:
        for name in ("Velocity", "AngularVelocity"):
            if unknown == "nan":
                file[f"VTKHDF/PointData/{name}"][...] = float("nan")
            else:
                del file[f"VTKHDF/PointData/{name}"]
    done = solver("run", "next.yaml", "--out", "next", "--quiet")
    assert done.returncode == 0, done.stderr
    assert "the state gives no velocities and angular velocities; they are taken as zero" in done.stderr


def test_a_velocity_that_is_not_finite_is_refused(solver):
    solver.good("run", "particles.yaml", "--out", "out", "--quiet")
    text = (solver.folder / "particles.yaml").read_text()
    solver.write("next.yaml", text.replace("particles: table.csv", "start_from: out/run.vtkhdf"))
    with h5py.File(solver.folder / "out/run.vtkhdf", "r+") as file:
        file["VTKHDF/PointData/Velocity"][0] = [0, float("nan"), 0]
    assert "particle 0 has a velocity or angular velocity that is not finite" in solver.refusal("run", "next.yaml", "--out", "next")


def test_the_same_scene_with_another_table_is_another_run(solver):
    solver.good("run", "particles.yaml", "--out", "out", "--quiet")
    table = (solver.folder / "table.csv").read_text()
    solver.write("table.csv", table.replace("-0.05", "-0.04"))
    assert "another configuration" in solver.refusal("run", "particles.yaml", "--out", "out")
    solver.write("table.csv", table)
    assert "finished already" in solver("run", "particles.yaml", "--out", "out").stderr


def test_resuming_needs_no_input_file(solver):
    solver.good("run", "particles.yaml", "--out", "out", "--quiet", "--until-step", 100)
    (solver.folder / "table.csv").unlink()
    solver.good("resume", "out", "--quiet")
    assert solver.summary("out")["status"] == "finished"


def test_a_finished_run_is_not_repeated_and_another_is_refused(solver):
    solver.good("run", "particles.yaml", "--out", "out", "--quiet")
    again = solver("run", "particles.yaml", "--out", "out")
    assert again.returncode == 0 and "finished already" in again.stderr
    resumed = solver("resume", "out")
    assert resumed.returncode == 0 and "finished already" in resumed.stderr
    sentence = solver.refusal("run", "particles.yaml", "--out", "out", "--set", "duration=30 us")
    assert "another configuration" in sentence
    solver.good("run", "particles.yaml", "--out", "out", "--quiet", "--overwrite", "--set", "duration=30 us")
    assert solver.summary("out")["steps"] == 300


def test_a_fault_leaves_the_moment_before(solver):
    # two spheres half inside each other at original stiffness are thrown apart beyond any speed that can be followed
    table = (solver.folder / "table.csv").read_text()
    solver.write("table.csv", table + "0,0,120e-6,25e-6,0,0,0,0,0,0\n0,0,130e-6,25e-6,0,0,0,0,0,0\n")
    result = solver("run", "particles.yaml", "--out", "out", "--set", "stiffness_ratio=1", "--set", "time_step=2e-8 s")
    assert result.returncode == 3, (result.returncode, result.stderr)
    assert "fault.vtkhdf" in result.stderr
    with h5py.File(solver.folder / "out/fault.vtkhdf") as file:
        assert np.all(np.isfinite(file["VTKHDF/Points"][()]))
    assert not (solver.folder / "out/summary.json").exists()


def test_a_sphere_rolls_over_the_seam_of_two_boxes_as_over_a_plane(solver, model):
    scene = f"scene: particles\n{model}particles: table.csv\ntime_step: 2e-8 s\ncohesion: {{bond_number: 50}}\nduration: 1.2 ms\nwalls:\n"
    scene = scene.replace("time_step: 1e-7 s\n", "")
    solver.write("table.csv", "x,y,z,radius,vx,vy,vz,wx,wy,wz\n-40e-6,0,25e-6,25e-6,0.05,0,0,0,2000,0\n")
    solver.write("plane.yaml", scene + "  - plane: {name: floor, normal: [0, 0, 1]}\n")
    solver.write(
        "seam.yaml",
        scene
        + "  - box: {name: left, lower: [-inf, -inf, -100 um], upper: [0 um, inf, 0 um]}\n"
        + "  - box: {name: right, lower: [0 um, -inf, -100 um], upper: [inf, inf, 0 um]}\n",
    )
    speed = {}
    for floor in ("plane", "seam"):
        solver.good("run", f"{floor}.yaml", "--out", floor, "--quiet", "--threads", 1)
        with h5py.File(solver.folder / floor / "run.vtkhdf") as file:
            speed[floor] = file["VTKHDF/PointData/Velocity"][0, 0]
    assert speed["plane"] == pytest.approx(0.041508, abs=1e-6)
    assert speed["seam"] == pytest.approx(speed["plane"], rel=1e-9)


def test_a_stage_in_which_nothing_happens_balances(solver):
    settings = ("--set", "cohesion.bond_number=400", "--set", "stages.fill.settle_energy=1e-4", "--set", "stages.fill.settle_time=20 ms")
    solver.write("spread.yaml", (solver.folder / "spread.yaml").read_text().split("  - heap")[0] + "  - run: {duration: 5 ms}\n")
    solver.good("run", "spread.yaml", "--out", "out", "--quiet", "--threads", 1, *settings)
    rest = solver.summary("out")["stages"][1]["energy"]
    assert abs(rest["balance_error_relative"]) < 1e-6, rest


@pytest.mark.parametrize("number", [signal.SIGINT, signal.SIGTERM])
def test_a_signal_stops_with_a_checkpoint_and_the_run_continues(solver, number):
    command = [solver.program, "run", "spread.yaml", "--out", "out", "--threads", "1",
               "--set", "stages.fill.settle_time=20 s", "--set", "stages.fill.settle_energy=1e-30"]
    process = subprocess.Popen(command, cwd=solver.folder, stderr=subprocess.PIPE, text=True)
    deadline = time.monotonic() + 30
    while not (solver.folder / "out/trajectory.frames/000001.vtkhdf").exists() and time.monotonic() < deadline:
        time.sleep(0.02)
    os.kill(process.pid, number)
    _, text = process.communicate(timeout=30)
    assert process.returncode == 128 + number, text
    assert "recoat-solve resume out" in text
    stopped = solver.summary("out")
    assert stopped["status"] == "stopped"
    solver.good("resume", "out", "--quiet", "--until-step", stopped["steps"] + 100)
    assert solver.summary("out")["steps"] == stopped["steps"] + 100


@pytest.mark.parametrize("example", ["collision", "wall_impact", "sliding", "pull_off"])
def test_the_small_examples_come_to_their_end(solver, root, example):
    """The sphere between floor and lid gains energy slowly while it waits: no reason to stop it."""
    solver.good("run", root / f"config/examples/{example}.yaml", "--out", "out", "--threads", 1, "--quiet")
    assert solver.summary("out")["status"] == "finished"


def test_progress_goes_to_standard_error_unless_quiet(solver):
    loud = solver("run", "particles.yaml", "--out", "loud")
    assert loud.stdout == "" and "run: 200 steps" in loud.stderr
    quiet = solver("run", "particles.yaml", "--out", "quiet", "--quiet")
    assert quiet.stdout == "" and quiet.stderr == ""
