"""Breaks some hundred runs and tells what became of each kind: `make faults`. Ends with 1 if anything came out wrong."""

import argparse
import functools
import json
import random
import sys
import tempfile
from pathlib import Path

import broken_runs
import damage
import full_disk

SKIPPED = "cannot mount here"
SAME_BITS = "all with the same bits"


def kills(runs, rounds, seed):
    """{what the runs came to: number of kills}, or the sentence of the run that came to another end."""
    try:
        killed, ended = broken_runs.kill_rounds(runs, rounds, seed)
    except AssertionError as error:
        return f"wrong result: {error}"
    return {f"kills in {ended} runs, {SAME_BITS}": killed}


def mounted(function):
    return function() if full_disk.can_mount() else SKIPPED


def kinds(spread, block, arguments):
    """What is broken, the function that does it, and the outcome, or {outcome: times}, that there must be; for kills
    the least number of them."""
    draw = random.Random(arguments.seed)
    most, flips, cuts = arguments.rounds * 4 // 5, arguments.flips, arguments.flips // 5
    earlier, tries = arguments.flips // 10, max(1, arguments.rounds // 15)
    checkpoints = {damage.REFUSED: flips + cuts - earlier, damage.CONTINUED: earlier}
    stopped = {full_disk.GOOD: tries}
    bind = functools.partial
    return [
        ("kill -9 at a random instant, 150 spheres", bind(kills, spread, most, arguments.seed), most),
        ("kill -9, 4096 spheres, 1 and 2 threads", bind(kills, block, arguments.rounds - most, arguments.seed),
         arguments.rounds - most),
        ("one bit of the checkpoint flipped, or its end cut off",
         bind(damage.damaged_checkpoints, spread, draw, flips, cuts, earlier), checkpoints),
        ("one bit of a frame of the trajectory flipped", bind(damage.damaged_frames, spread, draw, cuts),
         {damage.REFUSED: cuts}),
        ("a second process in the same folder", bind(damage.second_process, spread), damage.REFUSED),
        ("files that cannot grow (RLIMIT_FSIZE)", bind(full_disk.limited_files, spread, draw, tries), stopped),
        ("file system full (tmpfs)", bind(mounted, bind(full_disk.full_file_system, spread, draw, tries)), stopped),
        ("output folder read-only", bind(full_disk.read_only_folder, spread), full_disk.LATER),
    ]


def is_right(happened, expected):
    """Whether `happened` is what it must be, each outcome as often as it was tried: none left out, none besides."""
    if happened == SKIPPED:
        return True
    if isinstance(expected, int):
        return isinstance(happened, dict) and all(SAME_BITS in each for each in happened) and (
            sum(happened.values()) >= max(1, expected)
        )
    return happened == expected


def campaign(table):
    """Runs the kinds of a table, prints what happened; the outcomes, and the closing sentence if one is wrong."""
    outcomes, wrong, skipped = {}, [], []
    for what, function, expected in table:
        outcomes[what] = happened = function()
        right = is_right(happened, expected)
        print(f"{what}: {happened}" + ("" if right else f"; expected {expected}"), flush=True)
        wrong += [] if right else [what]
        skipped += [what] if happened == SKIPPED else []
    if skipped:
        print(f"Not tried: {', '.join(skipped)}.")
    sentence = f"{len(wrong)} of {len(outcomes)} kinds of faults came out wrong: {', '.join(wrong)}." if wrong else None
    return outcomes, sentence


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
        outcomes, wrong = campaign(kinds(spread, block, arguments))
    arguments.out.mkdir(parents=True, exist_ok=True)
    (arguments.out / "faults.json").write_text(json.dumps(outcomes, indent=1) + "\n")
    sys.exit(wrong)


if __name__ == "__main__":
    main()
