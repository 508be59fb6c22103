"""What stands beside every number: machine, date, commit."""

import datetime
import os
import platform
import subprocess
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
VECTORS = ("avx512f", "avx2", "sse4_2")


def description():
    """Processor, vectors, cache and cores in words."""
    lines = Path("/proc/cpuinfo").read_text().splitlines()
    values = {key.strip(): value.strip() for key, _, value in (line.partition(":") for line in lines)}
    flags = values.get("flags", "").split()
    vectors = next((name for name in VECTORS if name in flags), "no vectors")
    family = f"family {values.get('cpu family', '?')} model {values.get('model', '?')}"
    return f"{values.get('model name', 'unknown')} ({family}), {vectors}, {cache()} L2, {os.cpu_count()} cores, {platform.machine()}"


def cache():
    """Size of the second-level cache of a core, e.g. 2048K."""
    size = Path("/sys/devices/system/cpu/cpu0/cache/index2/size")
    return size.read_text().strip() if size.exists() else "unknown"


def commit(revision="HEAD"):
    """Short name of the commit; "-dirty" where HEAD has changes beside it."""
    arguments = ["describe", "--always", "--dirty", "--exclude", "*"] if revision == "HEAD" else ["rev-parse", "--short", f"{revision}^{{commit}}"]
    done = subprocess.run(["git", *arguments], cwd=ROOT, capture_output=True, text=True, check=False)
    if done.returncode != 0:
        raise SystemExit(f"{revision}: git knows no such commit ({done.stderr.strip()}); name one that is in this repository")
    return done.stdout.strip()


def header(command):
    """First entries of a file of results."""
    today = datetime.datetime.now(datetime.timezone.utc).date().isoformat()
    return {"command": command, "date": today, "machine": description(), "commit": commit()}
