"""Measures everything of docs/performance.md about the solver on a processor, in turn, and writes bench/results/speed.json.

usage: bench/speed/bench.py [--minutes 30] [--base COMMIT] [--shorten N] [--no-counts] [--out FILE]
Goes on where it was stopped: runs that are done are in results/bench, by the fingerprint of the program, until all are.
"""

import argparse
import hashlib
import json
import os
import sys
import time
from pathlib import Path

import counts
import whole_case
import yaml
from commits import built
from contenders import Case, Ours, Peer
from journal import Journal
from machine import ROOT, description, header
from measuring import run
from peers import Peers
from recoat import Build
from rows import case_rows, skipped_rows, whole_rows
from scenes import prepare

PLAN = yaml.safe_load((ROOT / "bench/speed/plan.yaml").read_text())
WORK = ROOT / "results/bench"


def arguments():
    parser = argparse.ArgumentParser(description="Rates of the solver beside those of others")
    parser.add_argument("--build", default=os.environ.get("RECOAT_BUILD", ROOT / "build/release"))
    parser.add_argument("--base", default=PLAN["former_commit"], help="commit that takes turns with today's; empty: none")
    parser.add_argument("--minutes", type=float, default=30, help="no run starts later, but for one round of every case")
    parser.add_argument("--shorten", type=int, default=1, help="divides all numbers of steps: 100 to see whether everything runs")
    parser.add_argument("--no-counts", action="store_true", help="leaves out what callgrind counts")
    parser.add_argument("--out", default=ROOT / "bench/results/speed.json")
    return parser.parse_args()


class Bench:
    """All contenders and the journal of their runs."""

    def __init__(self, options):
        self.options, self.start = options, time.monotonic()
        self.steps = shortened(PLAN["scenes"], options.shorten)
        self.repeats, self.other_repeats = PLAN["repeats"], PLAN["other_repeats"]
        machine = hashlib.sha256(description().encode()).hexdigest()[:8]
        self.journal = Journal(WORK / f"journal-{machine}.jsonl")
        self.files = prepare(ROOT / "build/bench-scenes", list(self.steps))
        self.today = Build("recoat", options.build)
        self.base = Build(f"recoat at {options.base}", built(options.base, os.cpu_count())) if options.base else None
        self.contenders = [*self.by_precision(), *self.others(), *self.peers()]

    def ours(self, name, build, required=(), preferred=tuple(PLAN["awake"]), cases=lambda case: True):
        return Ours(name, build, self.files, self.steps, tuple(required), preferred, cases)

    def by_precision(self):
        """Every precision with the best vectors of the machine, and in key cases on one thread with AVX2 where those are wider."""
        _, key = self.cases()
        for name, setting in PLAN["precisions"].items():
            yield self.ours(f"recoat, {name}", self.today, (setting,))
            if self.today.instruction_set() == "avx512":
                narrow = self.ours(f"recoat, {name}, avx2", self.today, (setting,), cases=lambda case: case in key and case.threads == 1)
                narrow.instruction_set = "avx2"
                yield narrow

    def others(self):
        """Today's default where precision is no choice, and the former commit on one thread."""
        if not self.today.accepts(self.files["bed"], (PLAN["precisions"]["double"],)):
            yield self.ours("recoat", self.today)
        if self.base:
            yield self.ours(self.base.name, self.base, cases=lambda case: case.threads == 1)

    def peers(self):
        """With cohesion they run on one core at the smallest Bond number that has any, for a law of their own."""
        peers = Peers(ROOT / "build/bench-peers", self.files)
        skins = tuple(float(skin) for skin in PLAN["skins"])

        def cases(case):
            return case.bond == 0 or (case.threads == 1 and case.bond == PLAN["bond_numbers"][1])

        for name, like in (("LIGGGHTS", "LIGGGHTS"), ("LAMMPS granular", "LAMMPS hertz"), ("LAMMPS hertz", "LAMMPS hertz"), ("LAMMPS hertz, omp", "LAMMPS hertz")):
            yield Peer(name, peers, self.steps, skins, like, self.journal, cases)

    def cases(self):
        """Every case, and the key ones."""
        every = [Case(scene, bond, threads) for threads in (1, 2) for bond in PLAN["bond_numbers"] for scene in PLAN["main_scenes"]]
        return every, [Case(scene, bond, threads) for bond, scene, threads in PLAN["key_cases"]]

    def entries(self, cases):
        return [((str(case), contender.name), contender, case) for case in cases for contender in self.contenders if contender.takes(case)]

    def minutes(self):
        return (time.monotonic() - self.start) / 60

    def rounds(self, entries, repeats):
        """Runs the entries (key, contender, case) in turn, the next round backwards; returns lists of records by key."""
        records = {}
        for repeat in range(repeats):
            for key, contender, case in entries if repeat % 2 == 0 else reversed(entries):
                name = f"{contender.key(case)} | {repeat}"
                if repeat > 0 and self.minutes() > self.options.minutes and name not in self.journal.records:
                    continue
                record = self.journal.once(name, lambda: contender.run(case))
                records.setdefault(key, []).append(record)
                say(self.minutes(), name, record)
        return records


def shortened(plan, divisor):
    """A plan with all its numbers of steps divided."""
    return {key: shortened(value, divisor) if isinstance(value, dict) else max(2, value // divisor) for key, value in plan.items()}


def say(minutes, name, record):
    result = "not available" if record is None else f"failed: {record['failed']}" if "failed" in record else f"{record['rate']:.3g}/s"
    print(f"{minutes:5.1f} min  {name}: {result}", flush=True)


def limits(bench):
    """Of the machine, on one thread and on all cores."""
    program = bench.today.folder / "bench/machine-limits"

    def measure(threads):
        done = run([program, "--threads", threads])
        if done.code != 0:
            raise RuntimeError(f"{program}: {done.errors.strip()}")
        return json.loads(done.output) | {"others": done.others}

    return [bench.journal.once(f"limits {threads}", lambda: measure(threads)) for threads in (1, 2)]


def counted(bench):
    """Instructions, operations and bytes per particle-step, by scene and Bond number."""
    plan = PLAN["counts"] | shortened({"steps": PLAN["counts"]["steps"]}, bench.options.shorten)
    program, bonds = counts.build(os.cpu_count()), PLAN["bond_numbers"]
    precisions = counts.precisions_of(bench.today, bench.files["bed"], PLAN["precisions"], PLAN["awake"])
    rows = []
    for row in counts.rows_of(program, plan, bonds, precisions, bench.files, bench.journal.once):
        print(f"{bench.minutes():5.1f} min  counts: {row}", flush=True)
        rows.append(row)
    return rows


def skipped(bench):
    """Pairs of cases of which one has something that the other has not."""
    entries = []
    for row in PLAN["skipped"]:
        for side in ("with", "without"):
            entries.append(((row["what"], side), skipped_contender(bench, row, row[side]), Case(row[side]["scene"], row[side]["bond"], 1)))
    return skipped_rows(PLAN["skipped"], bench.rounds(entries, bench.other_repeats))


def skipped_contender(bench, row, side):
    """Ours with the settings of one side of a row, and with its own number of steps before the clock starts."""
    settings, steps = side.get("set", []), dict(bench.steps)
    if "warm" in row:
        warm = max(2, row["warm"] // bench.options.shorten)
        steps[side["scene"]] = steps[side["scene"]] | {"warm": warm, "warm_cohesive": warm}
    awake = [setting for setting in PLAN["awake"] if setting.split("=")[0] not in {given.split("=")[0] for given in settings}]
    return Ours("recoat", bench.today, bench.files, steps, tuple(settings), tuple(awake))


def whole(bench):
    """Today's case and that of the former commit, at the automatic step of each, with everything on as a user has it."""
    builds = [build for build in (bench.today, bench.base) if build]
    entries, predictions = [], {}
    for bond in PLAN["bond_numbers"]:
        for build in builds:
            contender = bench.ours(f"{build.name}, as a user has it", build, (whole_case.AUTOMATIC,), ())
            entries.append(((bond, build.name), contender, Case("heap", bond, 1)))
    pieces = bench.rounds(entries, bench.other_repeats)
    for repeat in range(bench.other_repeats):
        for bond in PLAN["bond_numbers"]:
            for build in builds:
                key = f"check {build.fingerprint()} {bond} | {repeat}"
                record = bench.journal.once(key, lambda: whole_case.predicted(build, bond))
                predictions.setdefault((bond, build.name), []).append(record)
    return whole_rows(PLAN["bond_numbers"], [build.name for build in builds], predictions, pieces)


def main():
    options = arguments()
    bench = Bench(options)
    result = header("bench/speed/bench.py " + " ".join(sys.argv[1:])) | {"instruction_set": bench.today.instruction_set(), "load_average_before": os.getloadavg()}
    every, key = bench.cases()
    records = bench.rounds(bench.entries(key), bench.repeats)
    result["limits"], result["counts"] = limits(bench), [] if options.no_counts else counted(bench)
    result["skipped"], result["whole_case"] = skipped(bench), whole(bench)
    records |= bench.rounds(bench.entries([case for case in every if case not in key]), bench.other_repeats)
    result["side_by_side"] = case_rows(every, bench.contenders, records)
    result["minutes"] = round(bench.minutes(), 1)
    Path(options.out).write_text(json.dumps(result, indent=1) + "\n")
    bench.journal.close()
    print(f"Written: {options.out}, after {result['minutes']} minutes")


if __name__ == "__main__":
    main()
