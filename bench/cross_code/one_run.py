"""Snakemake: one run of one code."""

import json
import sys
from pathlib import Path

sys.path.insert(0, "bench/cross_code")

from run_case import run_case

output, params, wildcards = Path(snakemake.output[0]), snakemake.params, snakemake.wildcards
result = run_case(
    params.plan, wildcards.case, int(wildcards.seed), wildcards.code, params.lammps, output.parent, params.build
)
output.write_text(json.dumps(result))
