"""No room left, and folders that cannot be written to."""

import collections
import functools
import os
import resource
import signal
import subprocess
import tempfile
from pathlib import Path

from broken_runs import is_one_sentence

GOOD = "stopped with a sentence, then the same bits"
LATER = "refused, then the same bits"
ROOM = "had room enough"


def judge(runs, out, broken, more=None):
    """`broken` must have been stopped with a sentence; then the run must come to the same end."""
    if broken.returncode == 0:
        return ROOM
    if broken.returncode != 2 or not is_one_sentence(broken.stderr):
        return f"exit {broken.returncode}: {broken.stderr}"
    done = more() if more else runs.run(out, resume=any(out.glob("checkpoint*.h5")))
    if done.returncode != 0:
        return f"exit {done.returncode} afterwards: {done.stderr}"
    return GOOD if runs.same_as_undisturbed(out) else "wrong result"


def forbid_growth(size):
    signal.signal(signal.SIGXFSZ, signal.SIG_IGN)  # writing then fails as on a full disk
    resource.setrlimit(resource.RLIMIT_FSIZE, (size, size))


def limited_files(runs, draw, tries):
    """No file may be larger than some bytes; the limit grows as a user would make room."""
    largest = max(file.stat().st_size for file in (runs.folder / "whole").iterdir() if file.is_file())
    found = collections.Counter()
    while sum(found.values()) - found[ROOM] < tries:
        out = runs.new_folder("limited")
        size = draw.randrange(1, largest)
        broken = runs.run(out, preexec_fn=functools.partial(forbid_growth, size))
        found[judge(runs, out, broken)] += 1
    found.pop(ROOM, None)
    return dict(found)


@functools.cache
def can_mount():
    """Whether a file system can be mounted, as root or in a namespace of one's own."""
    with tempfile.TemporaryDirectory() as folder:
        words = ["unshare", "-rm", "mount", "-t", "tmpfs", "-o", "size=1m", "tmpfs", folder]
        try:
            return subprocess.run(words, capture_output=True, check=False).returncode == 0
        except FileNotFoundError:
            return False


# Runs in the namespace: a file system of $SIZE KiB; the run meets its end; then it grows; then the run goes on.
SCRIPT = """
mount -t tmpfs -o size=${SIZE}k tmpfs "$PLACE" || exit 77
"$PROGRAM" run "$SCENE" --out "$PLACE/out" --threads 1 2>"$ERRORS"
echo $? >"$ERRORS.code"
mount -o remount,size=256m "$PLACE"
if ls "$PLACE"/out/checkpoint*.h5 >/dev/null 2>&1; then
    "$PROGRAM" resume "$PLACE/out" --threads 2 || exit $?
else
    "$PROGRAM" run "$SCENE" --out "$PLACE/out" --threads 2 || exit $?
fi
cp -r "$PLACE/out/." "$KEPT"
"""


def full_file_system(runs, draw, tries):
    """A file system that is too small, which then grows."""
    needed = sum(file.stat().st_size for file in (runs.folder / "whole").rglob("*")) // 1024
    place = runs.folder / "mounted"
    place.mkdir(exist_ok=True)
    found = collections.Counter()
    while sum(found.values()) - found[ROOM] < tries:
        out = runs.new_folder("grown")
        out.mkdir()
        errors = runs.folder / "errors.txt"
        names = {"PLACE": place, "SCENE": runs.scene, "PROGRAM": runs.program, "ERRORS": errors, "KEPT": out,
                 "SIZE": draw.randrange(16, needed)}
        resumed = subprocess.run(["unshare", "-rm", "sh", "-c", SCRIPT], capture_output=True, text=True, check=False,
                                 env=os.environ | {name: str(value) for name, value in names.items()})
        code = int(Path(f"{errors}.code").read_text())
        broken = subprocess.CompletedProcess([], code, stderr=errors.read_text())
        found[judge(runs, out, broken, lambda result=resumed: result)] += 1
    found.pop(ROOM, None)
    return dict(found)


def read_only_folder(runs):
    """A folder that becomes read-only while the run is stopped. Root may write anywhere, so it becomes nobody."""
    out = runs.new_folder("locked")
    steps = runs.expected["summary.json"]["steps"]
    assert runs.run(out, more=["--until-step", str(steps // 2)]).returncode == 0
    user = {"user": 65534} if os.geteuid() == 0 else {}
    if user:
        for folder in [*runs.folder.parents, runs.folder]:  # that nobody can get there at all
            if os.stat(folder).st_uid == 0 and not os.stat(folder).st_mode & 1:
                os.chmod(folder, os.stat(folder).st_mode | 0o511)
    out.chmod(0o555)
    refused = runs.run(out, resume=True, **user)
    out.chmod(0o755)
    if refused.returncode != 2 or not is_one_sentence(refused.stderr):
        return f"exit {refused.returncode}: {refused.stderr}"
    done = runs.run(out, resume=True)
    return LATER if done.returncode == 0 and runs.same_as_undisturbed(out) else f"wrong result: {done.stderr}"
