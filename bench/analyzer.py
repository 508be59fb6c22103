"""Measures recoat-analyze, alone and beside numpy, scipy and PoreSpy, and writes bench/results/analyzer.json.

usage: bench/analyzer.py OUT.json [largest number of particles = 1000000]   (PEER_PYTHON: a Python with bench/requirements.txt)
"""

import datetime
import json
import os
import platform
import subprocess
import sys
import tempfile
import time
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
BUILD = Path(os.environ.get("RECOAT_BUILD", ROOT / "build/release"))
PEER = os.environ.get("PEER_PYTHON", sys.executable)
THREADS = 2
# Number of particles and length [d_p]: one areal density, 40 d_p wide.
LAYERS = {14_000: 549, 100_000: 3921, 1_000_000: 39_214}
RESOLUTIONS = (10, 20)


def run(command):
    done = subprocess.run(command, capture_output=True, text=True, check=True)
    return done.stdout


def as_process(command):
    """Seconds and memory of a whole process."""
    start = time.perf_counter()
    with subprocess.Popen(command, stdout=subprocess.DEVNULL) as process:
        _, status, usage = os.wait4(process.pid, 0)
        process.returncode = os.waitstatus_to_exitcode(status)
    if process.returncode != 0:
        raise SystemExit(f"{command[0]} ended with {process.returncode}")
    wall = time.perf_counter() - start
    return {"wall": wall, "cpu": usage.ru_utime + usage.ru_stime, "peak_memory_MiB": usage.ru_maxrss // 1024}


def settings(length, voxels):
    given = ["y_period=40 dp", f"x_range=[0, {length} dp]", f"voxels_per_dp={list(voxels)}", "bootstrap_resamples=0"]
    return ["--config", ROOT / "bench/data/random-layer.yaml"] + [part for setting in given for part in ("--set", setting)]


def layer(folder, particles, spread=0.0):
    file = folder / f"{particles}-{spread}.csv"
    run([BUILD / "bench/random-layer", file, "--particles", str(particles), "--length", str(LAYERS[particles]), "--width", "40", "--spread", str(spread)])
    return file


def parts(file, length, voxels, repeats, extra=()):
    command = [BUILD / "bench/analyzer-times", file, *settings(length, voxels), "--threads", str(THREADS), "--repeats", str(repeats), *extra]
    return json.loads(run(command))


def machine():
    info = Path("/proc/cpuinfo").read_text()
    model = next((line.split(":")[1].strip() for line in info.splitlines() if line.startswith("model name")), "unknown")
    return f"{model}, {os.cpu_count()} cores, {platform.machine()}"


def side_by_side(folder):
    file = layer(folder, 14_000)
    result = {"recoat": parts(file, LAYERS[14_000], RESOLUTIONS, 9)}
    peer = [PEER, ROOT / "bench/analyzer_peer.py", file, str(LAYERS[14_000]), "40", *map(str, RESOLUTIONS)]
    result["numpy, scipy, PoreSpy"] = json.loads(run(peer))
    report = folder / "report.json"
    run([BUILD / "analyzer/recoat-analyze", "metrics", file, *settings(LAYERS[14_000], RESOLUTIONS), "--quiet", "--json", report])
    values = json.loads(report.read_text())
    result["values of recoat"] = {
        "contacts": values["clusters"]["n_contacts"],
        "clusters": values["clusters"]["n_clusters"],
        "chambers A, D >= 0.5": values["chamber_pores"]["A"]["count"],
    }
    for n in RESOLUTIONS:
        voxel = values["voxel"][str(n)]
        result["values of recoat"] |= {f"voxel median phi {n}": voxel["phi"]["median"], f"voxel mean height {n}": voxel["height"]["mean"]}
        result["values of recoat"] |= {f"pixel chambers P {n}, D >= 0.5": voxel["chamber_P"]["count"], f"errors of these {n}": voxel["chamber_P_errors"]}
    return result


def growth(folder, largest):
    result = {}
    for particles, length in LAYERS.items():
        if particles > largest:
            continue
        file = layer(folder, particles)
        command = [BUILD / "analyzer/recoat-analyze", "metrics", file, "--quiet", "--threads", str(THREADS)]
        result[particles] = {
            "exact, in memory": parts(file, length, (), 9 if particles < 1e6 else 3),
            "program, exact": as_process([*command, *settings(length, ()), "--json", folder / "out.json"]),
            "program, with voxels 10 and 20": as_process([*command, *settings(length, RESOLUTIONS), "--json", folder / "out.json"]),
        }
        file.unlink()
    return result


def main():
    out = Path(sys.argv[1])
    largest = int(sys.argv[2]) if len(sys.argv) > 2 else max(LAYERS)
    commit = subprocess.run(["git", "describe", "--always", "--dirty"], cwd=ROOT, capture_output=True, text=True, check=False)
    result = {
        "what": "analysis of random layers, 40 d_p wide, 0.64 particles per d_p^2 (bench/random-layer), seconds",
        "command": f"bench/analyzer.py {' '.join(sys.argv[1:])}",
        "date": datetime.date.today().isoformat(),
        "machine": machine(),
        "commit": commit.stdout.strip(),
        "threads": THREADS,
        "load_average_before": os.getloadavg(),
    }
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        result["14,000 particles"] = side_by_side(folder)
        unequal = layer(folder, 14_000, 0.2)
        result["14,000 particles, unequal radii"] = parts(unequal, LAYERS[14_000], (), 9, ["--set", "contact_mode=radii"])
        result["growth"] = growth(folder, largest)
    result["load_average_after"] = os.getloadavg()
    out.write_text(json.dumps(result, indent=1) + "\n")
    print(f"written to {out}")


main()
