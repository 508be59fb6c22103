"""Instructions, floating-point operations and bytes of one particle-step, counted by callgrind on an AVX2 build.

Callgrind knows no AVX-512, so a build of its own for AVX2 is counted, the same wherever it is made, in build/counted.
An operation on a vector counts once for each of its lanes, a fused multiply-add twice; comparisons and moves do not.
Bytes requested are the operands of loads and stores. Bytes from beyond the second-level cache are 64 for each miss of
a simulated cache of 512 KiB behind 32 KiB; what goes back to memory is not in them.
"""

import hashlib
import os
import re
from collections import Counter
from concurrent.futures import ThreadPoolExecutor
from functools import cache, partial
from pathlib import Path
from tempfile import TemporaryDirectory

from measuring import run
from recoat import with_set
from scenes import ROOT

LINE = 64
CACHES = ("--I1=32768,8,64", "--D1=32768,8,64", "--LL=524288,8,64")
COUNTED_FUNCTION = "*timed_steps*"

WIDTHS = {"zmm": 64, "ymm": 32, "xmm": 16}
ARITHMETIC = re.compile(r"^v?(?P<fused>fn?m(?:add|sub|addsub|subadd)\d{3}|add|sub|mul|div|sqrt|rsqrt|rcp|addsub)(?P<kind>[ps][ds])$")
QUOTIENT = re.compile(r"^v?(div|sqrt)")  # approximations of them take no more time than other operations
OPERANDS = {"ZMMWORD": 64, "YMMWORD": 32, "XMMWORD": 16, "QWORD": 8, "DWORD": 4, "WORD": 2, "BYTE": 1, "TBYTE": 10}
INSTRUCTION = re.compile(r"^\s*([0-9a-f]+):\s+(?:\{\w+\}\s+)?([a-z0-9]+)\s*(.*)$")


def build(cores, source=ROOT):
    """Builds step-rate for AVX2 from the sources in a folder; returns the program."""
    folder = source / "build/counted"
    configure = ["cmake", "-S", source, "-B", folder, "-G", "Ninja", "--log-level=WARNING", "-DCMAKE_BUILD_TYPE=Release"]
    options = ["-DRECOAT_NATIVE=OFF", "-DRECOAT_TESTS=OFF", "-DRECOAT_CUDA=OFF", "-DCMAKE_CXX_FLAGS=-march=x86-64-v3"]
    make = ["cmake", "--build", folder, "--parallel", cores, "--target", "step-rate"]
    for command in ([*configure, *options], make):
        done = run(command, cwd=source)
        if done.code != 0:
            raise SystemExit(f"{' '.join(map(str, command))} failed:\n{(done.output + done.errors)[-2000:]}")
    return folder / "bench/step-rate"


def fingerprint(file):
    """Changes whenever the file does: the program, or how it is counted."""
    return hashlib.sha256(file.read_bytes()).hexdigest()[:16]


def operations(mnemonic, operands):
    """Floating-point operations of one instruction, over all lanes."""
    match = ARITHMETIC.match(mnemonic)
    if not match:
        return 0
    size = 8 if match["kind"].endswith("d") else 4
    width = next((bytes_ for name, bytes_ in WIDTHS.items() if name in operands), 16)
    lanes = width // size if match["kind"].startswith("p") else 1
    return lanes * (2 if match["fused"].startswith(("fm", "fnm")) else 1)


def bytes_of(operands):
    """Size of the operand in memory of one instruction; that of a register where it has none, as for push and ret."""
    match = re.search(r"(\w+) PTR", operands)
    return OPERANDS.get(match[1], 8) if match else 8


@cache
def disassembly(program):
    """Mnemonic and operands by address."""
    done = run(["objdump", "-d", "-M", "intel", "--no-show-raw-insn", program])
    matches = (INSTRUCTION.match(line) for line in done.output.splitlines())
    return {int(match[1], 16): (match[2], match[3].split("#")[0]) for match in matches if match}


def events(file):
    """From a file of callgrind, uncompressed: names of events, totals, and for each object the counts by address."""
    names, totals, counts, current, skip = [], Counter(), {}, "", False
    for line in file.read_text().splitlines():
        if line.startswith("events:"):
            names = line.split()[1:]
        elif line.startswith("ob="):
            current = line[3:]
        elif line.startswith("calls="):
            skip = True
        elif line[:2] == "0x":
            if not skip:
                address, *fields = line.split()
                values = Counter(dict(zip(names, map(int, fields[1:]))))
                counts.setdefault(current, {}).setdefault(int(address, 16), Counter()).update(values)
                totals.update(values)
            skip = False
    return totals, counts


def count(program, scene, bond, warm, steps, settings=()):
    """Counts per particle-step over `steps` steps after `warm` that do not count."""
    command = [program, "--scene", scene, "--bond", f"{bond:g}", "--threads", 1, "--warm", warm, "--steps", steps, *with_set(settings)]
    with TemporaryDirectory() as folder:
        out = Path(folder) / "callgrind.out"
        tool = ["valgrind", "--tool=callgrind", "--dump-instr=yes", "--cache-sim=yes", *CACHES, f"--callgrind-out-file={out}"]
        done = run([*tool, "--compress-strings=no", "--compress-pos=no", f"--toggle-collect={COUNTED_FUNCTION}", *command])
        if done.code != 0:
            raise RuntimeError(f"{' '.join(map(str, command))} under callgrind: {done.errors[-1000:]}")
        found = events(out)
    particles = int(re.search(r'"particles": (\d+)', done.output)[1])
    return per_particle_step(*found, disassembly(program), str(program), particles * steps)


def per_particle_step(totals, counts, code, program, work):
    """The table's entries from the counts."""
    flops = quotients = requested = 0
    for name, addresses in counts.items():
        for address, values in addresses.items():
            mnemonic, operands = code.get(address, ("", "")) if name == program else ("", "")
            done = values["Ir"] * operations(mnemonic, operands)
            flops += done
            quotients += done if QUOTIENT.match(mnemonic) else 0
            requested += (values["Dr"] + values["Dw"]) * bytes_of(operands)
    misses = [LINE * (totals[f"{level}mr"] + totals[f"{level}mw"]) for level in ("D1", "DL")]
    entries = {"instructions": totals["Ir"], "operations": flops, "quotients_and_roots": quotients, "bytes_requested": requested}
    entries |= {"bytes_beyond_first_cache": misses[0], "bytes_beyond_second_cache": misses[1]}
    return {name: round(value / work, 2) for name, value in entries.items()}


def rows_of(program, plan, bonds, precisions, files, once=lambda key, make: make()):
    """Counts of the scenes of a plan at Bond numbers, several at a time; `precisions`: settings of each by name;
    `once(key, make)` makes a record, or knows it already."""
    same = f"{fingerprint(program)} {fingerprint(Path(__file__))} {plan['warm']} {plan['steps']}"
    cases = [(scene, bond, name) for scene in plan["scenes"] for bond in bonds for name in precisions]

    def row(case):
        scene, bond, name = case
        make = partial(count, program, files[scene], bond, plan["warm"], plan["steps"], precisions[name])
        return {"scene": scene, "bond_number": bond, "precision": name, **once(f"counts {same} {scene} {bond} {' '.join(precisions[name])}", make)}

    with ThreadPoolExecutor(os.cpu_count()) as pool:
        yield from pool.map(row, cases)


def precisions_of(build, file, precisions, others):
    """Settings of every precision that a build knows, with those of the others that it knows; {"": ...} where it knows none."""
    known = {name: (setting, *build.known(file, others)) for name, setting in precisions.items() if build.accepts(file, (setting,))}
    return known or {"": build.known(file, others)}
