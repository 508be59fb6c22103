"""Breaks some hundred runs and tells what became of each kind: `make faults`."""

import argparse
import json
import random
import tempfile
from pathlib import Path

import broken_runs
import damage
import full_disk


def table(spread, block, arguments):
    """Pairs of what was broken and what happened."""
    draw = random.Random(arguments.seed)
    most = arguments.rounds * 4 // 5
    kills, ended = broken_runs.kill_rounds(spread, most, arguments.seed)
    yield "kill -9 at a random instant, 150 spheres", f"{kills} kills in {ended} runs, all with the same bits"
    kills, ended = broken_runs.kill_rounds(block, arguments.rounds - most, arguments.seed)
    yield "kill -9, 4096 spheres, 1 and 2 threads", f"{kills} kills in {ended} runs, all with the same bits"
    found = damage.damaged_checkpoints(spread, draw, arguments.flips, arguments.flips // 5, arguments.flips // 10)
    yield "one bit of the checkpoint flipped, or its end cut off", found
    yield "one bit of a frame of the trajectory flipped", damage.damaged_frames(spread, draw, arguments.flips // 5)
    yield "a second process in the same folder", damage.second_process(spread)
    tries = max(1, arguments.rounds // 15)
    yield "files that cannot grow (RLIMIT_FSIZE)", full_disk.limited_files(spread, draw, tries)
    mounted = full_disk.can_mount()
    yield "file system full (tmpfs)", full_disk.full_file_system(spread, draw, tries) if mounted else "cannot mount here"
    yield "output folder read-only", full_disk.read_only_folder(spread)


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("program", type=Path)
    parser.add_argument("--rounds", type=int, default=300, help="kills")
    parser.add_argument("--flips", type=int, default=500, help="of bits of checkpoints")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--out", type=Path, required=True)
    arguments = parser.parse_args()
    with tempfile.TemporaryDirectory() as folder:
        spread = broken_runs.Runs(arguments.program, Path(folder) / "spread", broken_runs.SPREAD)
        block = broken_runs.Runs(arguments.program, Path(folder) / "block", broken_runs.BLOCK, broken_runs.block_table())
        rows = []
        for what, happened in table(spread, block, arguments):
            rows.append((what, happened))
            print(f"{what}: {happened}", flush=True)
    arguments.out.mkdir(parents=True, exist_ok=True)
    (arguments.out / "faults.json").write_text(json.dumps(dict(rows), indent=1) + "\n")


if __name__ == "__main__":
    main()
