"""Counts instructions, operations and bytes per particle-step of today's sources and adds them to those of former commits.

usage: bench/speed/instructions.py [--commit COMMIT] [--scenes bed heap layer] [--bonds 0 50 400] [--out FILE]
Counts do not depend on how busy the machine is: a minute of processor time for each scene and Bond number.
"""

import argparse
import json
import os
from pathlib import Path

import counts
import yaml
from commits import built
from machine import ROOT, commit, header
from recoat import Build
from scenes import prepare

PLAN = yaml.safe_load((ROOT / "bench/speed/plan.yaml").read_text())


def compared(row, former):
    """A line with the counts, and in brackets their ratios to those of another commit."""
    same = [other for other in former if all(other[key] == row[key] for key in ("scene", "bond_number"))]
    known = next((other for other in same if other["precision"] == row["precision"]), same[0] if same else None)
    parts = []
    for name, value in row.items():
        if name not in ("scene", "bond_number", "precision"):
            parts.append(f"{name} {value:.0f}" + (f" ({value / known[name]:.3f})" if known and known.get(name) else ""))
    return f"{row['scene']:<10} Bo {row['bond_number']:<5g} {row['precision']:<6} {', '.join(parts)}"


def sources(revision, build):
    """Folder of the sources to count, the build whose recoat-solve tells what they know, and the name of the commit."""
    if not revision:
        return ROOT, Build("today", build), commit()
    folder = built(revision, os.cpu_count())
    return folder.parents[1], Build(revision, folder), commit(revision)


def main():
    parser = argparse.ArgumentParser(description="Counts of a particle-step")
    parser.add_argument("--commit", help="a former commit, instead of today's sources")
    parser.add_argument("--build", default=os.environ.get("RECOAT_BUILD", ROOT / "build/release"), help="of today")
    parser.add_argument("--scenes", nargs="+", default=PLAN["counts"]["scenes"])
    parser.add_argument("--bonds", nargs="+", type=float, default=PLAN["bond_numbers"])
    parser.add_argument("--out", type=Path, default=ROOT / "bench/results/instructions.json")
    options = parser.parse_args()
    source, build, name = sources(options.commit, options.build)
    files = prepare(ROOT / "build/bench-scenes", options.scenes)
    history = json.loads(options.out.read_text()) if options.out.exists() else []
    others = [other for other in history if other["commit"] != name]
    former = others[-1] if others else {"rows": [], "commit": "none"}
    print(f"In brackets: ratio to {former['commit']}")
    entry = header("bench/speed/instructions.py") | {"commit": name, "rows": []}
    precisions = counts.precisions_of(build, files[options.scenes[0]], PLAN["precisions"], PLAN["awake"])
    plan = PLAN["counts"] | {"scenes": options.scenes}
    for row in counts.rows_of(counts.build(os.cpu_count(), source), plan, options.bonds, precisions, files):
        entry["rows"].append(row)
        print(compared(row, former["rows"]), flush=True)
        options.out.write_text(json.dumps([*others, entry], indent=1) + "\n")


if __name__ == "__main__":
    main()
