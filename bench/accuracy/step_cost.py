"""Processor seconds of one particle-step of a settled bed, for each Bond number, scheme, precision and step of two bodies."""

import gzip
import json
import subprocess
import tempfile
from pathlib import Path

from plan import PAPER_RATIO
from two_body_errors import STABILITY, scene_settings, steps_from
from workflow_scripts import Clock, solver_version, write_json

BED = "bench/data/settled-bed.csv.gz"
SHORTEST_STEP = 2e-8  # what a step costs does not depend on it while pairs need no bracketed solve [s]
REPEATS = 3
CHOICE = ("bond", "scheme", "precision")


def try_once(params, bed, case, step):
    """Particle-steps per second of processor time of one core; None beyond the stability limit."""
    command = [f"{params.build}/bench/step-rate", bed, "--scene", params.scene, "--bond", f"{case['bond']:g}"]
    command += ["--threads", "1", "--warm", "100", "--steps", "150"]
    command += scene_settings(case, step)
    run = subprocess.run(command, capture_output=True, text=True, check=False)
    if run.returncode == 2 and STABILITY in run.stderr:
        return None
    if run.returncode != 0:
        raise RuntimeError(f"{' '.join(map(str, command))}: {run.stderr.strip()}")
    found = json.loads(run.stdout)
    return found["particle_steps_per_second"] * found["seconds"] / found["processor_seconds"]


def rates(params, bed, case, shortest):
    """One row for each step up to the stability limit: the best of some tries."""
    for step in steps_from(shortest, params.grid["steps_per_decade"]):
        tries = [try_once(params, bed, case, step) for _ in range(REPEATS)]
        if tries[0] is None:
            return
        yield {key: case[key] for key in CHOICE} | {"time_step": step, "rate": max(tries)}


def table(params, bed):
    """Each choice and step once: at the ratio of the paper, and beyond its stability limit at softer ones."""
    rows = []
    for case in sorted(params.cases, key=lambda case: -case["ratio"]):
        if case["ratio"] <= PAPER_RATIO:
            known = [row["time_step"] for row in rows if all(row[key] == case[key] for key in CHOICE)]
            next_step = 10 ** (1 / params.grid["steps_per_decade"])
            rows += rates(params, bed, case, next_step * max(known) if known else SHORTEST_STEP)
    return sorted(rows, key=lambda row: (*(row[key] for key in CHOICE), row["time_step"]))


if __name__ == "__main__":
    clock = Clock()
    with tempfile.TemporaryDirectory() as folder:
        bed = Path(folder) / "bed.csv"
        bed.write_bytes(gzip.decompress(Path(BED).read_bytes()))
        rows = table(snakemake.params, bed)
    version = solver_version(snakemake.params.build)
    write_json(snakemake.output[0], {"version": version, "rows": rows} | clock.record())
