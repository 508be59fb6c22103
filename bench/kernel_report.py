"""Registers, spills and load widths of the CUDA engine's kernels, as the compiler made them.

usage: bench/kernel_report.py OUT.json [architecture ...]      (default: 80 90 100 120)
Needs nvcc and cuobjdump, no device. Fails when a kernel of the step spills registers to memory.
"""

import json
import re
import subprocess
import sys
import tempfile
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
SOURCE = "solver/engine/engine_cuda.cu"
FLAGS = ["-std=c++20", "-O3", "-DNDEBUG", "-I.", "--extended-lambda", "--expt-relaxed-constexpr", "-Xcompiler=-fopenmp,-O1"]
ENTRY = re.compile(
    r"Compiling entry function '(\S+)'.*?\n.*?\n\s+(\d+) bytes stack frame, (\d+) bytes spill stores, (\d+) bytes spill loads\n"
    r".*?Used (\d+) registers"
)


def call(*words):
    done = subprocess.run(words, cwd=ROOT, capture_output=True, text=True)
    if done.returncode:
        sys.exit(f"{' '.join(words[:2])} failed:\n{done.stderr}")
    return done.stdout + done.stderr


def readable(symbols):
    lines = subprocess.run(["c++filt"], input="\n".join(symbols), capture_output=True, text=True, check=True).stdout.splitlines()
    return dict(zip(symbols, lines))


def kernel_name(signature):
    """The pass a kernel of the step runs, or None for the others."""
    loop = re.search(r"kernels::(guarded\w*)<recoat::(?:ContactLoop|ParticleLoop)<recoat::(\w+)<(.*)", signature)
    if not loop:
        return None
    sizes = "equal" if "EqualSizes" in signature else "any"
    impulse = re.search(r"recoat::(\w+Impulse)(?:<\d>)?", loop[3])
    flags = re.findall(r"\b(?:true|false)\b", loop[3].split("> >")[0])
    details = [impulse[1]] if impulse else ["cohesive" if flag == "true" else "" for flag in flags[:1]]
    details += ["relative rolling" if flags[1:2] == ["true"] and not impulse else ""]
    return ", ".join(part for part in [loop[2], f"{sizes} sizes", *details] if part)


def sass_loads(binary):
    """Global loads by width in bytes, per kernel."""
    counts, kernel = {}, None
    for line in call("cuobjdump", "-sass", binary).splitlines():
        if "Function :" in line:
            kernel = line.split(":")[1].strip()
        elif load := re.search(r"\bLDG\.E(?:\.\w+)*", line):
            width = next((bits for bits in ("128", "64") if f".{bits}" in load[0]), "32")
            counts.setdefault(kernel, {}).setdefault(str(int(width) // 8), 0)
            counts[kernel][str(int(width) // 8)] += 1
    return counts


def report(architecture):
    with tempfile.TemporaryDirectory() as folder:
        binary = f"{folder}/engine.o"
        log = call("nvcc", *FLAGS, f"-arch=sm_{architecture}", "-Xptxas", "-v", "-c", SOURCE, "-o", binary)
        entries = ENTRY.findall(log)
        names, loads = readable([entry[0] for entry in entries]), sass_loads(binary)
    kernels = {}
    for symbol, stack, stores, reads, registers in entries:
        name = kernel_name(names[symbol])
        if name:
            kernels[name] = {
                "registers": int(registers),
                "spilled_bytes": int(stores) + int(reads),
                "stack_bytes": int(stack),
                "loads_by_bytes": loads.get(symbol, {}),
            }
    return dict(sorted(kernels.items()))


def main():
    out, architectures = Path(sys.argv[1]), sys.argv[2:] or ["80", "90", "100", "120"]
    with ThreadPoolExecutor(2) as pool:
        reports = dict(zip([f"sm_{a}" for a in architectures], pool.map(report, architectures)))
    version = call("nvcc", "--version").strip().splitlines()[-1]
    out.write_text(json.dumps({"compiler": version, "flags": FLAGS, "kernels": reports}, indent=1) + "\n")
    spilled = [f"{a}: {name}" for a, kernels in reports.items() for name, k in kernels.items() if k["spilled_bytes"]]
    if spilled or not all(reports.values()):
        sys.exit("kernels of the step that spill: " + "; ".join(spilled) if spilled else "no kernel of the step was found")


if __name__ == "__main__":
    main()
