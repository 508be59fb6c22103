"""Steps the same scenes with today's programs and with those of another commit, in turn, and prints the ratios of rates.

usage: bench/speed/against.py BASE [--builds FOLDER...] [--scenes bed heap ...] [--bonds 0 50 400] [--repeats 5] [--out FILE]
BASE: a commit, e.g. 6e58aa8, or a build folder. On a busy machine read the ratios by processor time.
"""

import argparse
import json
import os
from pathlib import Path

import yaml
from commits import built
from machine import ROOT, header
from measuring import DISTURBED
from recoat import Build
from scenes import prepare
from statistics_of_rates import ratios, spread

PLAN = yaml.safe_load((ROOT / "bench/speed/plan.yaml").read_text())
ONE_THREAD, BOTH = (1,), ("rate", "processor_rate")


def arguments():
    parser = argparse.ArgumentParser(description="Ratios of rates between two commits")
    parser.add_argument("base", help="commit, or build folder with bench/step-rate")
    parser.add_argument("--build", default=os.environ.get("RECOAT_BUILD", ROOT / "build/release"), help="of today")
    parser.add_argument("--scenes", nargs="+", choices=PLAN["scenes"], default=PLAN["main_scenes"])
    parser.add_argument("--bonds", nargs="+", type=float, default=PLAN["bond_numbers"])
    parser.add_argument("--threads", nargs="+", type=int, default=ONE_THREAD)
    parser.add_argument("--repeats", type=int, default=PLAN["repeats"])
    parser.add_argument("--shorten", type=float, default=1, help="divides the number of steps, for a first look")
    parser.add_argument("--set", nargs="+", default=[], help="a.b=v: settings of both")
    parser.add_argument("--set-today", nargs="+", default=[], help="a.b=v: settings of today's program only")
    parser.add_argument("--out", help="JSON file for the results")
    return parser.parse_args()


def steps_of(scene, bond, shorten):
    """Steps before the clock starts, and timed ones."""
    plan = PLAN["scenes"][scene]
    warm = plan["warm_cohesive" if bond > 0 else "warm"]
    return max(10, round(warm / shorten)), max(10, round(plan["steps"] / shorten))


def measure(builds, file, case, options):
    """All runs of one case: the builds in turn, first forwards, then backwards."""
    scene, bond, threads = case
    warm, steps = steps_of(scene, bond, options.shorten)
    runs = {build.name: [] for build in builds}
    for repeat in range(options.repeats):
        for build in builds if repeat % 2 == 0 else reversed(builds):
            settings = options.set + (options.set_today if build is builds[0] else [])
            result = build.rate(file, bond, threads, warm, steps, settings)
            if result is None:
                raise SystemExit(f"{build.name} does not know {' '.join(settings)}")
            runs[build.name].append(result)
    return runs


def summary(case, builds, runs):
    """One row of the table."""
    scene, bond, threads = case
    today, base = (runs[build.name] for build in builds)
    row = {"scene": scene, "bond_number": bond, "threads": threads}
    for kind in BOTH:
        row[kind] = {build.name: spread(run[kind] for run in runs[build.name]) for build in builds}
        row[kind]["ratio"] = ratios([run[kind] for run in today], [run[kind] for run in base])
    row["others_busy_cores"] = spread(run["others"] for run in today + base)
    return row


def text(row):
    by_clock, by_processor = (row[kind]["ratio"] for kind in BOTH)
    today, base = list(row["processor_rate"].values())[:2]
    busy = row["others_busy_cores"]["median"]
    return (
        f"{row['scene']:<10} Bo {row['bond_number']:<5g} {row['threads']} thread(s): {today['median']:.3g} against {base['median']:.3g} "
        f"particle-steps per processor second, ratio {by_processor['median']:.3f} ({by_processor['least']:.3f} to {by_processor['largest']:.3f}); "
        f"by the clock {by_clock['median']:.3f}{f'; others kept {busy:.1f} cores busy' if busy > DISTURBED else ''}"
    )


def main():
    options = arguments()
    folder = Path(options.base)
    base = Build(options.base, folder if folder.is_dir() else built(options.base, os.cpu_count()))
    builds = [Build("today", options.build), base]
    files = prepare(ROOT / "build/bench-scenes", options.scenes)
    result = header("bench/speed/against.py " + options.base) | {"base": options.base, "rows": []}
    for scene in options.scenes:
        for bond in options.bonds:
            for threads in options.threads:
                case = scene, bond, threads
                result["rows"].append(summary(case, builds, measure(builds, files[scene], case, options)))
                print(text(result["rows"][-1]), flush=True)
    if options.out:
        Path(options.out).write_text(json.dumps(result, indent=1) + "\n")


if __name__ == "__main__":
    main()
