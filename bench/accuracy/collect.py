"""bench/results/accuracy.json: two bodies, powder by study, and the steps that follow from them."""

import json
import os
import platform
import subprocess
from itertools import groupby
from pathlib import Path

from recommend import gain_at_equal_error, recommended_steps
from statistics_of_runs import summarise
from workflow_scripts import read_json, write_json

SETTING = ("kind", "bond", "ratio", "scheme", "shortcut", "skin", "close_steps", "time_step")


def processor():
    """Name of the processor, as the kernel says it."""
    names = [line.split(":", 1)[1].strip() for line in open("/proc/cpuinfo") if line.startswith("model name")]
    return names[0] if names else platform.processor()


def commit():
    """The state of the project that this was measured with."""
    return subprocess.run(
        ["git", "describe", "--always", "--dirty"], capture_output=True, text=True, check=True
    ).stdout.strip()


def with_cost(case, costs):
    """Adds to each step what a millisecond of a thousand particles costs at the rate of a settled bed [s]."""
    own = [row for row in costs if row["bond"] == case["bond"] and row["scheme"] == case["scheme"]]
    for row in case["steps"]:
        nearest = min(own, key=lambda cost: abs(cost["time_step"] / row["time_step"] - 1))
        row["processor_seconds"] = 1e-3 / row["time_step"] * 1000 / nearest["rate"]
    return case


def with_automatic_step(case, build, scene):
    """Adds the step that the solver takes by itself."""
    settings = {"time_step": "auto", "cohesion.bond_number": case["bond"], "stiffness_ratio": case["ratio"]}
    command = [f"{build}/solver/recoat-solve", "check", scene, "--json"]
    command += [part for key, value in settings.items() for part in ("--set", f"{key}={value}")]
    report = json.loads(subprocess.run(command, capture_output=True, text=True, check=True).stdout)
    return case | {"automatic_step": report["time_step"]}


def study(names, files):
    """The runs of one study, those that differ in the seed only taken together."""
    runs = sorted((read_json(files[name]) for name in names), key=lambda run: [run[key] for key in SETTING])
    groups = groupby(runs, key=lambda run: [run[key] for key in SETTING])
    return [dict(zip(SETTING, setting)) | summarise(list(members)) for setting, members in groups]


if __name__ == "__main__":
    files = {Path(path).stem: path for path in snakemake.input.runs}
    costs = read_json(snakemake.input.cost)
    two_body = [
        with_automatic_step(with_cost(read_json(path), costs), snakemake.params.build, snakemake.params.scene)
        for path in snakemake.input.two_body
    ]
    powder = {name: study(members, files) for name, members in snakemake.params.groups.items()}
    runs = [read_json(path) for path in snakemake.input.runs]
    write_json(
        snakemake.output[0],
        {
            "command": "make bench-accuracy",
            "commit": commit(),
            "solver": sorted({run["version"] for run in runs if "version" in run}),
            "machine": {"processor": processor(), "cores": os.cpu_count()},
            "powder_runs": len(runs),
            "powder_processor_seconds": sum(run["processor_seconds"] for run in runs),
            "recommended": recommended_steps(two_body, powder["time_step"]),
            "equal_error": gain_at_equal_error(two_body),
            "step_rates": costs,
            "two_body": two_body,
            "powder": powder,
        },
    )
