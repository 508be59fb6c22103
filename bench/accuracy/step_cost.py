"""Processor seconds of one particle-step of a settled bed, for each Bond number, scheme and time step."""

import gzip
import json
import subprocess
import tempfile
from itertools import product
from pathlib import Path

from workflow_scripts import write_json

BED = "bench/data/settled-bed.csv.gz"
STEPS = [2e-8, 5e-8, 1e-7, 2e-7, 4e-7]
REPEATS = 3


def rate(build, bed, bond, scheme, step):
    """Particle-steps per second of one core, the best of some tries."""
    command = [f"{build}/bench/step-rate", bed, "--bond", str(bond)]
    command += ["--set", f"cohesion.scheme={scheme}", "--set", f"time_step={step!r} s"]
    command += ["--threads", "1", "--warm", "200", "--steps", "300"]
    tries = [subprocess.run(command, capture_output=True, text=True, check=True).stdout for _ in range(REPEATS)]
    return max(json.loads(text)["particle_steps_per_second"] for text in tries)


if __name__ == "__main__":
    params = snakemake.params
    with tempfile.TemporaryDirectory() as folder:
        bed = Path(folder) / "bed.csv"
        bed.write_bytes(gzip.decompress(Path(BED).read_bytes()))
        rows = [
            {"bond": float(bond), "scheme": scheme, "time_step": step, "rate": rate(params.build, bed, bond, scheme, step)}
            for bond, scheme, step in product([0, *params.grid["bond_numbers"]], params.grid["schemes"], STEPS)
        ]
    write_json(snakemake.output[0], rows)
