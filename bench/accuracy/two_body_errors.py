"""Errors of two bodies for time steps up to the stability limit: impacts, sliding, pull-off."""

import json
import math
import subprocess
import sys
from functools import cache
from pathlib import Path

from workflow_scripts import Clock, solver_version, write_json

sys.path.insert(0, "tests/analytic")

from pull_off import pull_off_load  # noqa: E402
from reference import FAR, MASS, NEAR, RESTITUTION, WALL, Cohesive, damping  # noqa: E402

REFERENCE = json.loads(Path("tests/analytic/reference.json").read_text())
STABILITY = "stability limit"  # in the sentence that refuses a step


def steps_from(shortest, per_decade):
    """Time steps on a decade's even marks, to two digits: 5e-9, 6.3e-9, 7.9e-9, 1e-8, ..."""
    number = round(math.log10(shortest) * per_decade)
    while True:
        yield float(f"{10 ** (number / per_decade):.1e}")
        number += 1


def scene_settings(case, step):
    """Words of a command that make a case of a scene."""
    settings = {
        "cohesion.bond_number": f"{case['bond']:g}",
        "cohesion.scheme": case["scheme"],
        "precision": case["precision"],
        "stiffness_ratio": case["ratio"],
        "time_step": f"{step!r} s",
    }
    return [part for key, value in settings.items() for part in ("--set", f"{key}={value}")]


def measure(build, scene, case, step, grid):
    """What the program two-body finds at one time step; None beyond the stability limit."""
    bond = f"{case['bond']:g}"
    captures = [str(REFERENCE[f"capture.{kind}.{bond}"]) for kind in ("pair", "wall")]
    command = [f"{build}/bench/accuracy/two-body", scene, "--phases", str(grid["phases"])]
    command += ["--capture", *captures, "--ramp", str(grid["ramp"]), "--longest", str(2 * REFERENCE[f"stop.{bond}.time"])]
    command += scene_settings(case, step)
    run = subprocess.run(command, capture_output=True, text=True, check=False)
    if run.returncode == 2 and STABILITY in run.stderr:
        return None
    if run.returncode != 0:
        raise RuntimeError(f"{' '.join(command)}: {run.stderr.strip()}")
    return json.loads(run.stdout)


def spread(values, expected):
    """Mean and worst relative error over the phases; what never parted or never stayed is an error without bound."""
    errors = [math.inf if value is None else value / expected - 1 for value in values]
    mean, worst = sum(errors) / len(errors), max(errors, key=abs)
    return {"mean": finite(mean), "worst": finite(worst)}


def finite(value):
    """JSON has no infinity: null stands for it."""
    return value if math.isfinite(value) else None


@cache
def expected_pull_off(bond, ramp):
    """Load over the attraction at which a sphere leaves the wall, by adaptive integration of the ramp that is measured.

    The load goes on rising while the sphere leaves: with a ramp to twice the attraction in 2 ms by 3.1, 1.3 and 0.6 %
    at Bo 5, 50 and 400. The program raises it in parts of 4e-4 of the attraction, so that no error below half of that
    can be seen.
    """
    wall = Cohesive(float(bond), WALL)
    force, stiffness = wall.force / MASS, wall.stiffness / MASS
    return float(pull_off_load(force, stiffness, NEAR, FAR, damping(RESTITUTION), ramp, 20 * NEAR))


def errors_of(found, bond, ramp):
    """Relative errors against the reference."""
    errors = {}
    for kind in ("pair", "wall"):
        values = found[kind]
        errors[f"capture velocity, {kind}"] = spread(values["capture"], REFERENCE[f"capture.{kind}.{bond}"])
        errors[f"rebound from twice that, {kind}"] = spread(values["rebound"], REFERENCE[f"rebound.{kind}.{bond}.2"])
        errors[f"rebound from 0.05 m/s, {kind}"] = spread(values["fast"], REFERENCE[f"rebound.{kind}.{bond}.fast"])
    errors["stop distance"] = spread([found["stop_distance"]], REFERENCE[f"stop.{bond}.distance"])
    errors["pull-off force"] = spread([found["pull_off"]], expected_pull_off(bond, ramp))
    return errors


def table(build, scene, case, grid):
    """One row for each step."""
    rows = []
    for step in steps_from(case["shortest_step"], grid["steps_per_decade"]):
        found = measure(build, scene, case, step, grid)
        if found is None:
            return rows
        rows.append({"time_step": step, "errors": errors_of(found, f"{case['bond']:g}", float(grid["ramp"]))})


if __name__ == "__main__":
    params = snakemake.params
    clock = Clock()
    rows = table(params.build, params.scene, params.case, params.grid)
    about = {key: params.case[key] for key in ("bond", "ratio", "scheme", "precision")}
    write_json(snakemake.output[0], about | {"version": solver_version(params.build), "steps": rows} | clock.record())
