"""Processor time of the reduced grid with today's commit and with a former one, both after the build.

usage: bench/speed/reproduce.py BASE [--out bench/results/reproduce.json] [--configfile config/reduced.yaml]
Each commit is unpacked and built in build/against and makes the grid there from nothing: commit first what is to be measured.
"""

import argparse
import json
import os
import shutil
from pathlib import Path

import yaml
from commits import built
from machine import ROOT, commit, header
from measuring import run

PROGRAMS = ("step-rate", "recoat-solve", "recoat-analyze")


def snakemake(folder, configuration):
    """Wall and processor seconds of the grid, and the wall seconds of each of its runs of the solver."""
    results = folder / "results" / yaml.safe_load((folder / configuration).read_text())["name"]
    shutil.rmtree(results, ignore_errors=True)
    environment = os.environ | {"PATH": f"{ROOT / '.venv/bin'}:{os.environ['PATH']}"}
    done = run(["snakemake", "--configfile", configuration, "--cores", "all"], cwd=folder, env=environment)
    if done.code != 0:
        raise SystemExit(f"{folder}: snakemake ended with {done.code}\n{done.errors[-2000:]}")
    runs = {}
    for file in sorted(results.rglob("summary.json")):
        summary = json.loads(file.read_text())
        runs[str(file.parent.relative_to(results))] = {"steps": summary["steps"], "wall_seconds": summary["wall_seconds"]}
    return {"wall_seconds": done.wall, "processor_seconds": done.processor, "others_busy_cores": done.others, "runs": runs}


def main():
    parser = argparse.ArgumentParser(description="Processor time of the reduced grid with two commits")
    parser.add_argument("base", help="the former commit")
    parser.add_argument("--out", default=ROOT / "bench/results/reproduce.json")
    parser.add_argument("--configfile", default="config/reduced.yaml")
    options = parser.parse_args()
    result = header(f"bench/speed/reproduce.py {options.base} --configfile {options.configfile}") | {"programs": {}}
    names = [commit(f"{revision}~0") for revision in ("HEAD", options.base)]
    if names[0] == names[1]:
        raise SystemExit(f"{options.base} is the commit of today; name a former one")
    for name in names:
        folder = built(name, os.cpu_count(), PROGRAMS).parents[1]
        result["programs"][name] = snakemake(folder, options.configfile)
        print(f"{name}: {result['programs'][name]['processor_seconds']:.0f} s of processor time", flush=True)
    today, former = (entry["processor_seconds"] for entry in result["programs"].values())
    result["share_of_former"] = today / former
    Path(options.out).write_text(json.dumps(result, indent=1) + "\n")
    print(f"Today's share: {100 * today / former:.0f} %; written to {options.out}")


if __name__ == "__main__":
    main()
