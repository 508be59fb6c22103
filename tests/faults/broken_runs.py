"""Runs of recoat-solve that something breaks: killed, out of space, their files damaged."""

import json
import os
import random
import shutil
import signal
import subprocess
import time
from pathlib import Path

import h5py
import numpy as np

MODEL = """
stiffness_ratio: 0.001
time_step: 1e-7 s
gravity: 9.81 m/s2
material: {diameter: 50 um, density: 4430 kg/m3, young_modulus: 110 GPa, poisson_ratio: 0.3}
contact: {restitution: 0.4, sliding_friction: 0.3, rolling_friction: 0.01}
cohesion: {bond_number: 50}
"""
# A checkpoint every few milliseconds: most kills meet a file being written.
OUTPUT = "output: {trajectory_interval: 0.5 ms, energy_interval: 0.1 ms, checkpoint_interval: 5 ms}\n"

SPREAD = f"""scene: spread
{MODEL}
powder: {{particles: 150}}
box: {{length: 30 dp, width: 5 dp, fill_length: 6 dp}}
blade: {{clearance: 1.5 dp, speed: 100 mm/s}}
stages:
  - fill: {{settle_time: 3 ms}}
  - heap: {{settle_time: 1 ms}}
  - spread: {{length: 6 dp, settle_time: 0.3 ms}}
{OUTPUT}"""

# Large enough for two threads to share the loops.
BLOCK = f"""scene: particles
{MODEL}
particles: table.csv
walls:
  - plane: {{name: floor, normal: [0, 0, 1]}}
duration: 60 us
{OUTPUT.replace("0.5 ms", "6 us").replace("0.1 ms", "2 us")}"""


def block_table():
    """4096 spheres that touch their neighbours."""
    grid = np.indices((16, 16, 16)).reshape(3, -1).T * 49.9e-6 + 30e-6
    speed = np.sin(np.arange(grid.size)).reshape(grid.shape) * 1e-2
    rows = [",".join(map(repr, (*map(float, x), 25e-6, *map(float, v), 0.0, 0.0, 0.0))) for x, v in zip(grid, speed)]
    return "x,y,z,radius,vx,vy,vz,wx,wy,wz\n" + "\n".join(rows) + "\n"


def contents(out):
    """Everything that a finished run says of the simulation: arrays as bytes, the summary without clocks."""
    found = {}
    for file in sorted(Path(out).glob("*.vtkhdf")):
        with h5py.File(file) as state:
            data = state["VTKHDF"]
            names = ["Points", "Steps/Values", *(f"PointData/{name}" for name in sorted(data["PointData"]))]
            found[file.name] = {name: data[name][()].tobytes() for name in names}
    summary = json.loads((Path(out) / "summary.json").read_text())
    clock = {"wall_seconds", "particle_steps_per_second", "threads"}
    summary["stages"] = [{k: v for k, v in stage.items() if k not in clock} for stage in summary["stages"]]
    found["summary.json"] = {k: v for k, v in summary.items() if k not in clock}
    found["energy.csv"] = (Path(out) / "energy.csv").read_bytes()
    return found


class Runs:
    """One scene, its undisturbed run, and disturbed ones in folders beside it."""

    def __init__(self, program, folder, scene, table=""):
        self.program, self.folder = str(program), Path(folder)
        self.folder.mkdir(parents=True, exist_ok=True)
        self.scene = self.folder / "scene.yaml"
        self.scene.write_text(scene)
        (self.folder / "table.csv").write_text(table)
        start = time.monotonic()
        done = self.run(self.folder / "whole")
        assert done.returncode == 0, done.stderr
        self.seconds = time.monotonic() - start
        self.expected = contents(self.folder / "whole")

    def command(self, out, threads=1, resume=False):
        words = ["resume", str(out)] if resume else ["run", str(self.scene), "--out", str(out)]
        return [self.program, *words, "--threads", str(threads), "--quiet"]

    def run(self, out, threads=1, resume=False, more=(), **keys):
        keys = {"capture_output": True, "text": True, "timeout": 300, "check": False} | keys
        return subprocess.run([*self.command(out, threads, resume), *more], **keys)

    def new_folder(self, name):
        out = self.folder / name
        shutil.rmtree(out, ignore_errors=True)
        return out

    def same_as_undisturbed(self, out):
        return contents(out) == self.expected and not list(out.rglob("*.part"))

    def killed_run(self, out, instants, threads):
        """Starts a run and resumes it, killing it after each time that `instants` gives, until it is done. Returns the
        number of kills."""
        kills = 0
        while True:
            resume = any(out.glob("checkpoint*.h5"))
            process = subprocess.Popen(self.command(out, threads(), resume), stderr=subprocess.PIPE, text=True)
            try:
                _, text = process.communicate(timeout=instants())
            except subprocess.TimeoutExpired:
                os.kill(process.pid, signal.SIGKILL)
                process.communicate()
                kills += 1
                continue
            assert process.returncode == 0, text
            return kills


def is_one_sentence(text):
    """Notes, such as that the disk is small for the output, may come before the one sentence of the error."""
    lines = [line for line in text.strip().splitlines() if not line.startswith("Note: ")]
    return len(lines) == 1 and lines[0].startswith("recoat-solve: error: ")


def flip(file, bit):
    data = bytearray(file.read_bytes())
    data[bit // 8] ^= 1 << bit % 8
    file.write_bytes(data)


def kill_rounds(runs, rounds, seed):
    """At least `rounds` kills at random instants; every run that comes to its end must be the undisturbed one. Returns
    kills and runs."""
    draw = random.Random(seed)
    kills = ended = 0
    while kills < rounds:
        out = runs.new_folder("killed")
        # Short ones meet the start and the first files, long ones let the run come on even on a busy machine.
        kills += runs.killed_run(
            out, lambda: draw.uniform(0.002, draw.choice([0.02, 0.1, 0.5]) * runs.seconds), lambda: draw.choice([1, 2])
        )
        ended += 1
        assert runs.same_as_undisturbed(out), f"run {ended} after {kills} kills differs"
    return kills, ended


def stopped_half_way(runs, name):
    """A run with two checkpoints, stopped in its middle."""
    out = runs.new_folder(name)
    steps = runs.expected["summary.json"]["steps"]
    for until in (steps // 3, steps // 2):
        done = runs.run(out, resume=out.exists(), more=["--until-step", str(until)])
        assert done.returncode == 0, done.stderr
    assert (out / "checkpoint-previous.h5").exists()
    return out
