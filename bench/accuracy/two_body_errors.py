"""Errors of two bodies for time steps up to the stability limit: impacts, sliding, pull-off."""

import json
import math
import subprocess
from pathlib import Path

from workflow_scripts import write_json

REFERENCE = json.loads(Path("tests/analytic/reference.json").read_text())
STABILITY = "stability limit"  # in the sentence that refuses a step


def steps_from(shortest, per_decade):
    """Time steps on a decade's even marks, to two digits: 5e-9, 6.3e-9, 7.9e-9, 1e-8, ..."""
    number = round(math.log10(shortest) * per_decade)
    while True:
        yield float(f"{10 ** (number / per_decade):.1e}")
        number += 1


def measure(build, scene, case, step, grid):
    """What the program two-body finds at one time step; None beyond the stability limit."""
    bond = f"{case['bond']:g}"
    captures = [str(REFERENCE[f"capture.{kind}.{bond}"]) for kind in ("pair", "wall")]
    settings = {
        "cohesion.bond_number": bond,
        "cohesion.scheme": case["scheme"],
        "stiffness_ratio": case["ratio"],
        "time_step": f"{step!r} s",
    }
    command = [f"{build}/bench/accuracy/two-body", scene, "--phases", str(grid["phases"])]
    command += ["--capture", *captures, "--ramp", str(grid["ramp"]), "--longest", str(2 * REFERENCE[f"stop.{bond}.time"])]
    command += [part for key, value in settings.items() for part in ("--set", f"{key}={value}")]
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


def errors_of(found, bond):
    """Relative errors against the reference."""
    errors = {}
    for kind in ("pair", "wall"):
        values = found[kind]
        errors[f"capture velocity, {kind}"] = spread(values["capture"], REFERENCE[f"capture.{kind}.{bond}"])
        errors[f"rebound from twice that, {kind}"] = spread(values["rebound"], REFERENCE[f"rebound.{kind}.{bond}.2"])
        errors[f"rebound from 0.05 m/s, {kind}"] = spread(values["fast"], REFERENCE[f"rebound.{kind}.{bond}.fast"])
    errors["stop distance"] = spread([found["stop_distance"]], REFERENCE[f"stop.{bond}.distance"])
    errors["pull-off force"] = spread([found["pull_off"]], 1.0)
    return errors


def table(build, scene, case, grid):
    """One row for each step."""
    rows = []
    for step in steps_from(case["shortest_step"], grid["steps_per_decade"]):
        found = measure(build, scene, case, step, grid)
        if found is None:
            return rows
        rows.append({"time_step": step, "errors": errors_of(found, f"{case['bond']:g}")})


if __name__ == "__main__":
    params = snakemake.params
    rows = table(params.build, params.scene, params.case, params.grid)
    about = {key: params.case[key] for key in ("bond", "ratio", "scheme")}
    write_json(snakemake.output[0], about | {"steps": rows})
