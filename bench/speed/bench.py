"""Measures everything of docs/performance.md about the solver on a processor, in turn, and writes bench/results/speed.json.

usage: bench/speed/bench.py [--minutes 30] [--base COMMIT] [--quick] [--out FILE]
Goes on where it was stopped: runs that are done are in results/bench, by the fingerprint of the program, until all are.
"""

import argparse
import hashlib
import json
import os
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
    parser.add_argument("--quick", action="store_true", help="a hundredth of the steps and one round: does everything run?")
    parser.add_argument("--out", default=ROOT / "bench/results/speed.json")
    return parser.parse_args()


class Bench:
    """All contenders and the journal of their runs."""

    def __init__(self, options):
        self.options, self.start = options, time.monotonic()
        self.steps = shortened(PLAN["scenes"], 100) if options.quick else PLAN["scenes"]
        self.repeats = 1 if options.quick else PLAN["repeats"]
        machine = hashlib.sha256(description().encode()).hexdigest()[:8]
        self.journal = Journal(WORK / f"{'quick' if options.quick else 'journal'}-{machine}.jsonl")
        self.files = prepare(ROOT / "build/bench-scenes", list(self.steps))
        self.today = Build("recoat", options.build)
        self.base = Build(f"recoat at {options.base}", built(options.base, os.cpu_count())) if options.base else None
        by_precision = [self.ours(f"recoat, {name}", self.today, (setting,)) for name, setting in PLAN["precisions"].items()]
        self.contenders = [*by_precision, *self.others(), *self.peers()]

    def ours(self, name, build, required=(), preferred=tuple(PLAN["awake"]), cases=lambda case: True):
        return Ours(name, build, self.files, self.steps, tuple(required), preferred, cases)

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
        """The most important first."""
        for threads in (1, 2):
            for bond in PLAN["bond_numbers"]:
                yield from (Case(scene, bond, threads) for scene in PLAN["main_scenes"])

    def minutes(self):
        return (time.monotonic() - self.start) / 60

    def rounds(self, entries):
        """Runs the entries (key, contender, case) in turn, the next round backwards; returns lists of records by key."""
        records = {}
        for repeat in range(self.repeats):
            for key, contender, case in entries if repeat % 2 == 0 else reversed(entries):
                name = f"{contender.key(case)} | {repeat}"
                if repeat > 0 and self.minutes() > self.options.minutes and name not in self.journal.records:
                    continue
                record = self.journal.once(name, lambda: contender.run(case))
                records.setdefault(key, []).append(record)
                say(self.minutes(), name, record)
        return records


def shortened(scenes, divisor):
    """Plans of scenes with fewer steps."""

    def less(value):
        return {key: less(part) for key, part in value.items()} if isinstance(value, dict) else max(2, value // divisor)

    return {scene: less(plan) for scene, plan in scenes.items()}


def say(minutes, name, record):
    result = "not available" if record is None else f"failed: {record['failed']}" if "failed" in record else f"{record['rate']:.3g}/s"
    print(f"{minutes:5.1f} min  {name}: {result}", flush=True)


def limits(bench):
    """Of the machine, on one thread and on all cores."""
    program = bench.today.folder / "bench/machine-limits"
    memory = ["--memory", 48] if bench.options.quick else []

    def measure(threads):
        done = run([program, "--threads", threads, *memory])
        if done.code != 0:
            raise RuntimeError(f"{program}: {done.errors.strip()}")
        return json.loads(done.output) | {"others": done.others}

    return [bench.journal.once(f"limits {threads}", lambda: measure(threads)) for threads in (1, 2)]


def counted(bench):
    """Instructions, operations and bytes per particle-step, by scene and Bond number."""
    plan = shortened({"counts": {key: PLAN["counts"][key] for key in ("warm", "steps")}}, 50 if bench.options.quick else 1)["counts"]
    program = counts.build(os.cpu_count())
    fingerprint = counts.fingerprint(program)
    rows = []
    for scene in PLAN["counts"]["scenes"]:
        for bond in PLAN["bond_numbers"] if not bench.options.quick else [0]:
            key = f"counts {fingerprint} {scene} {bond} {plan['steps']}"
            settings = [setting for setting in PLAN["awake"] if bench.today.accepts(bench.files[scene], (setting,))]
            record = bench.journal.once(key, lambda: counts.count(program, bench.files[scene], bond, plan["warm"], plan["steps"], settings))
            rows.append({"scene": scene, "bond_number": bond, **record})
            print(f"{bench.minutes():5.1f} min  {key}: {record}", flush=True)
    return rows


def side_by_side(bench):
    entries = [((str(case), contender.name), contender, case) for case in bench.cases() for contender in bench.contenders if contender.takes(case)]
    return case_rows(list(bench.cases()), bench.contenders, bench.rounds(entries), bench.base.name if bench.base else None)


def skipped(bench):
    entries = []
    for row in PLAN["skipped"]:
        for side in ("with", "without"):
            settings = row[side].get("set", [])
            preferred = () if settings and settings[0].startswith("sleep") else tuple(PLAN["awake"])
            contender = bench.ours("recoat", bench.today, settings, preferred)
            entries.append(((row["what"], side), contender, Case(row[side]["scene"], row[side]["bond"], 1)))
    return skipped_rows(PLAN["skipped"], bench.rounds(entries))


def whole(bench):
    """Today's case and that of the former commit, at the automatic step of each, with everything on as a user has it."""
    builds = [build for build in (bench.today, bench.base) if build]
    entries, predictions = [], {}
    for bond in PLAN["bond_numbers"]:
        for build in builds:
            contender = bench.ours(f"{build.name}, as a user has it", build, (whole_case.AUTOMATIC,), ())
            entries.append(((bond, build.name), contender, Case("heap", bond, 1)))
    pieces = bench.rounds(entries)
    for repeat in range(min(3, bench.repeats)):
        for bond in PLAN["bond_numbers"]:
            for build in builds:
                key = f"check {build.fingerprint()} {bond} | {repeat}"
                record = bench.journal.once(key, lambda: whole_case.predicted(build, bond))
                predictions.setdefault((bond, build.name), []).append(record)
    return whole_rows(PLAN["bond_numbers"], [build.name for build in builds], predictions, pieces)


def main():
    options = arguments()
    bench = Bench(options)
    result = header("bench/speed/bench.py" + (" --quick" if options.quick else "")) | {"load_average_before": os.getloadavg()}
    result["limits"] = limits(bench)
    result["counts"] = counted(bench)
    for name, part in (("side_by_side", side_by_side), ("skipped", skipped), ("whole_case", whole)):
        result[name] = part(bench)
    result["minutes"] = round(bench.minutes(), 1)
    Path(options.out).write_text(json.dumps(result, indent=1) + "\n")
    bench.journal.close()
    print(f"Written: {options.out}, after {result['minutes']} minutes")


if __name__ == "__main__":
    main()
