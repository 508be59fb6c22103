"""Damaged files, and a second process in the folder."""

import collections
import shutil
import subprocess
import time

from broken_runs import flip, is_one_sentence, stopped_half_way

REFUSED = "refused"
CONTINUED = "continued from the earlier one to the same bits"


def outcome(runs, out):
    """What `resume` makes of a damaged folder."""
    done = runs.run(out, resume=True)
    if done.returncode == 2 and is_one_sentence(done.stderr):
        return REFUSED
    if done.returncode != 0:
        return f"exit {done.returncode}: {done.stderr}"
    return CONTINUED if runs.same_as_undisturbed(out) else "wrong result"


def copied(runs, source, name):
    out = runs.new_folder(name)
    shutil.copytree(source, out)
    return out


def damaged_checkpoints(runs, draw, flips, cuts, finished):
    """Flips single bits of checkpoints and cuts them; alone they must be refused, and `finished` times of all, with an
    earlier one beside them, the run must come to the same end."""
    source = stopped_half_way(runs, "half")
    found = collections.Counter()
    size = (source / "checkpoint.h5").stat().st_size
    for k in range(flips + cuts):
        out = copied(runs, source, "damaged")
        file = out / "checkpoint.h5"
        if k < flips:
            flip(file, draw.randrange(8 * size))
        else:
            file.write_bytes(file.read_bytes()[: draw.randrange(size)])
        if k >= finished:
            (out / "checkpoint-previous.h5").unlink()
        found[outcome(runs, out)] += 1
    return dict(found)


def damaged_frames(runs, draw, flips):
    """Flips single bits of frames of the trajectory that are not joined yet."""
    source = stopped_half_way(runs, "half")
    found = collections.Counter()
    for _ in range(flips):
        out = copied(runs, source, "damaged")
        file = draw.choice(sorted((out / "trajectory.frames").iterdir()))
        flip(file, draw.randrange(8 * file.stat().st_size))
        found[outcome(runs, out)] += 1
    return dict(found)


def second_process(runs):
    """Starts a second run in the folder of one that is under way."""
    out = runs.new_folder("two")
    first = subprocess.Popen(runs.command(out), stderr=subprocess.DEVNULL)
    try:
        while not (out / "checkpoint.h5").exists() and first.poll() is None:
            time.sleep(0.001)
        second = runs.run(out, resume=True)
    finally:
        first.wait()
    refused = second.returncode == 2 and is_one_sentence(second.stderr) and "another recoat-solve" in second.stderr
    if refused and first.returncode == 0 and runs.same_as_undisturbed(out):
        return REFUSED
    return f"exit {second.returncode}: {second.stderr}"
