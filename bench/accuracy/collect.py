"""bench/results/accuracy.json: two bodies, powder by study, and the steps that follow from them."""

import json
import os
import platform
import subprocess
import sys
from itertools import groupby
from math import isclose
from pathlib import Path

from recommend import PAPER_RATIO, gain_at_equal_error, recommended_steps
from statistics_of_runs import summarise
from step_cost import CHOICE
from workflow_scripts import Implausible, read_json, write_json

SETTING = ("kind", "bond", "ratio", "scheme", "precision", "shortcut", "skin", "close_steps", "time_step")
SHORT_STEP = 2e-8  # below it the solve of the pair is the same at every step, and so is its rate
AGAIN = "'make bench-accuracy' makes runs anew whose files in results/accuracy are gone"


def processor():
    """Name of the processor, as the kernel says it."""
    names = [line.split(":", 1)[1].strip() for line in open("/proc/cpuinfo") if line.startswith("model name")]
    return names[0] if names else platform.processor()


def git(*words):
    """What a git command prints."""
    return subprocess.run(["git", *words], capture_output=True, text=True, check=True).stdout.strip()


def commit():
    """The state of the project that this was collected with; "-dirty" if any file but the results themselves differs."""
    changed = git("status", "--porcelain", "--untracked-files=no", "--", ".", ":!bench/results")
    return git("describe", "--always") + ("-dirty" if changed else "")


def version_of_all(parts):
    """The one version of the solver that made all records, given by file; Implausible if they differ."""
    first = {}
    for path, record in parts.items():
        first.setdefault(record.get("version") if isinstance(record, dict) else None, path)
    if len(first) > 1:
        met = ", ".join(f"{version or 'unknown'} ({path})" for version, path in first.items())
        raise Implausible(f"Results of different solvers cannot be put together: {met}; {AGAIN}.")
    return next(iter(first))


def sums(records, key):
    """Seconds of each part and of all; of runs in parallel each has its own."""
    seconds = {part: sum(record[key] for record in members) for part, members in records.items()}
    return seconds | {"total": sum(seconds.values())}


def rate_at(own, step):
    """Particle-steps per second at a time step: of the row at that very step.

    Shorter steps than SHORT_STEP may take that of the nearest row up to it. Longer ones may not: the solve of the pair
    gets dearer with the step, in leaps.
    """
    exact = [row for row in own if isclose(row["time_step"], step, rel_tol=1e-9)]
    short = [row for row in own if row["time_step"] <= SHORT_STEP]
    if not exact and not (step < SHORT_STEP and short):
        raise Implausible(f"No rate of a settled bed is known at a step of {step:g} s; {AGAIN}, here step_cost.json.")
    return (exact or [min(short, key=lambda row: abs(row["time_step"] / step - 1))])[0]["rate"]


def with_cost(case, costs):
    """Adds to each step what a millisecond of a thousand particles costs at the rate of a settled bed [s].

    Rates are those of the ratio of the paper, and beyond its stability limit of softer ones: what a step costs goes
    with the step and the attraction.
    """
    own = [row for row in costs if all(row[key] == case[key] for key in CHOICE)]
    for row in case["steps"]:
        row["processor_seconds"] = 1e-3 / row["time_step"] * 1000 / rate_at(own, row["time_step"])
    return case


def automatic_step(bond, ratio, build, scene):
    """The step that the solver takes by itself [s]."""
    settings = {"time_step": "auto", "cohesion.bond_number": bond, "stiffness_ratio": ratio}
    command = [f"{build}/solver/recoat-solve", "check", scene, "--json"]
    command += [part for key, value in settings.items() for part in ("--set", f"{key}={value}")]
    return json.loads(subprocess.run(command, capture_output=True, text=True, check=True).stdout)["time_step"]


def with_automatic_steps(recommended, build, scene):
    """Adds to each kind of run and Bond number the step that the solver takes by itself."""
    for row in recommended["powder"]:
        row["automatic_step"] = automatic_step(row["bond"], PAPER_RATIO, build, scene)
    return recommended


def study(names, files):
    """The runs of one study, those that differ in the seed only taken together."""
    runs = sorted((files[name] for name in names), key=lambda run: [run[key] for key in SETTING])
    groups = groupby(runs, key=lambda run: [run[key] for key in SETTING])
    return [dict(zip(SETTING, setting)) | summarise(list(members)) for setting, members in groups]


def header(parts, records):
    """What was measured with what, and what that took."""
    runs = records["powder"]
    return {
        "command": "make bench-accuracy",
        "commit": commit(),
        "solver": version_of_all(parts),
        "machine": {"processor": processor(), "cores": os.cpu_count()},
        "powder_runs": len(runs),
        "faulted_runs": sum(run["exit_code"] != 0 for run in runs),
        "processor_seconds": sums(records, "processor_seconds"),
        "wall_seconds": sums(records, "wall_seconds"),
    }


def collect(inputs, params):
    """Everything, as it is written."""
    parts = {path: read_json(path) for path in (*inputs.runs, *inputs.two_body, inputs.cost)}
    records = {
        "powder": [parts[path] for path in inputs.runs],
        "two_body": [parts[path] for path in inputs.two_body],
        "step_cost": [parts[inputs.cost]],
    }
    head = header(parts, records)
    costs = parts[inputs.cost]["rows"]
    two_body = [
        with_cost(case, costs)
        | {"automatic_step": automatic_step(case["bond"], case["ratio"], params.build, params.scene)}
        for case in records["two_body"]
    ]
    mixed = [case for case in two_body if case["precision"] == "mixed"]
    two_body = [case for case in two_body if case["precision"] == "double"]
    files = {Path(path).stem: parts[path] for path in inputs.runs}
    powder = {name: study(members, files) for name, members in params.groups.items()}
    recommended = recommended_steps(two_body, powder["time_step"])
    return head | {
        "recommended": with_automatic_steps(recommended, params.build, params.scene),
        "equal_error": gain_at_equal_error(two_body),
        "step_rates": costs,
        "two_body": two_body,
        "two_body_mixed": mixed,
        "powder": powder,
    }


if __name__ == "__main__":
    try:
        write_json(snakemake.output[0], collect(snakemake.input, snakemake.params))
    except Implausible as error:
        sys.exit(f"bench-accuracy: {error}")
