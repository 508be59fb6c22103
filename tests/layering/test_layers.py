"""Dependencies point downward, files stay small, headers stand alone."""

import json
import re
import shlex
import subprocess
from concurrent.futures import ThreadPoolExecutor
from os import cpu_count
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]

SOLVER = ["common", "common/tables", "solver/execution", "solver/contact", "solver/engine", "solver/scene", "solver/output", "solver", "solver/cli", "solver/main"]
ANALYZER = [
    "common",
    "common/tables",
    "analyzer/readers",
    "analyzer/division",
    "analyzer/region",
    "analyzer/configuration",
    "analyzer/fields",
    "analyzer/metrics",
    "analyzer/analysis",
    "analyzer/convergence",
    "analyzer/uncertainty",
    "analyzer/output",
    "analyzer/read_arguments",
    "analyzer/commands",
    "analyzer",
]

# What each layer may include besides itself. A layer is a folder, or a file (without its ending) that has its own entry.
ALLOWED = {layer: set(SOLVER[:i]) for i, layer in enumerate(SOLVER)}
ALLOWED |= {layer: set(ANALYZER[:i]) for i, layer in enumerate(ANALYZER)}

# Libraries that a device compiler would have to digest, or that have no place in a kernel.
HEAVY = re.compile(r"<(Eigen|openvdb|CGAL|hdf5|H5|yaml-cpp|tbb|nlohmann|CLI)[/.\w]*")
KERNELS = ("solver/execution", "solver/contact", "solver/engine")
LARGEST_FILE = 300

INCLUDE = re.compile(r'^\s*#\s*include\s*(?:"([^"]+)"|(<[^>]+>))', re.MULTILINE)


def sources(*patterns):
    return sorted(
        file for top in ("common", "solver", "analyzer") for pattern in patterns for file in (ROOT / top).rglob(pattern)
    )


def folder_of(path):
    return str(Path(path).parent)


def layer_of(path):
    file = str(Path(path).with_suffix(""))
    return file if file in ALLOWED else folder_of(path)


def includes(file):
    return [own or system for own, system in INCLUDE.findall(file.read_text())]


def upward(file):
    """Includes of our own files that the layers forbid."""
    layer = layer_of(file.relative_to(ROOT))
    own = [name for name in includes(file) if "/" in name and not name.startswith("<")]
    return [name for name in own if layer_of(name) != layer and layer_of(name) not in ALLOWED[layer]]


def name(file):
    return str(file.relative_to(ROOT))


@pytest.mark.parametrize("file", sources("*.hpp", "*.cuh", "*.cpp", "*.cu"), ids=name)
def test_file_includes_only_what_lies_below(file):
    assert layer_of(file.relative_to(ROOT)) in ALLOWED, "a new folder needs its place in the layers"
    assert upward(file) == []


@pytest.mark.parametrize("folder", KERNELS)
def test_kernels_know_no_heavy_library(folder):
    files = [f for f in sources("*.hpp", "*.cuh", "*.cpp", "*.cu") if folder_of(f.relative_to(ROOT)) == folder]
    assert files
    # What the headers of common bring in counts as well.
    reached = {ROOT / n for f in files for n in includes(f) if (ROOT / n).is_file()} | set(files)
    assert {name(f): [i for i in includes(f) if HEAVY.match(i)] for f in reached} == {name(f): [] for f in reached}


def test_layer_check_sees_an_upward_include(tmp_path, monkeypatch):
    monkeypatch.setattr(f"{__name__}.ROOT", tmp_path)
    header = tmp_path / "solver/contact/bad.hpp"
    header.parent.mkdir(parents=True)
    header.write_text('#pragma once\n#include "solver/engine/engine.hpp"\n#include "common/vec3.hpp"\n#include <vector>\n')
    assert upward(header) == ["solver/engine/engine.hpp"]


def code_files():
    listed = subprocess.run(
        ["git", "ls-files", "--cached", "--others", "--exclude-standard"], cwd=ROOT, capture_output=True, text=True, check=True
    ).stdout.split()
    suffixes = (".hpp", ".cuh", ".cpp", ".cu", ".py", ".smk", ".sh")
    return [f for f in listed if f.endswith(suffixes) and (ROOT / f).is_file()]


def test_files_stay_small():
    lengths = {file: len((ROOT / file).read_text().splitlines()) for file in code_files()}
    assert lengths
    assert {file: n for file, n in lengths.items() if n >= LARGEST_FILE} == {}


def test_headers_have_a_guard():
    assert [name(f) for f in sources("*.hpp") if not f.read_text().startswith("#pragma once\n")] == []


def compile_flags(build):
    """Compiler and flags for the files of each folder, from the compile commands of the build."""
    flags = {}
    for command in json.loads((build / "compile_commands.json").read_text()):
        words = shlex.split(command["command"])
        words = words[1:] if Path(words[0]).name == "ccache" else words
        folder = Path(command["file"]).resolve().parent
        flags.setdefault(folder, [w for w in words[: words.index("-o")] if not w.startswith("-O")])
    return flags


def comes_first_in_its_source(header):
    """The build itself shows then that the header needs nothing before it."""
    source = header.with_suffix(".cpp")
    return source.exists() and includes(source)[:1] == [name(header)]


def instruction_sets(header):
    """Flags of the translation units that a header with vector instructions is for."""
    sets = ["-mavx2", "-mfma", "-mavx512f", "-mavx512dq", "-mavx512bw", "-mavx512vl", "-mavx512cd"]
    return sets if header.name.startswith("simd_") else []


def test_loops_of_an_instruction_set_define_nothing_that_others_would_call(build):
    """The linker keeps one of several inline functions of a name: it must never be one that only some machines run."""
    objects = sorted((build / "solver/engine").rglob("tile_kernels_avx*.o"))
    for file in objects:
        symbols = subprocess.run(["nm", "-C", file], capture_output=True, text=True, check=True).stdout.splitlines()
        defined = [line.split(maxsplit=2)[2] for line in symbols if line[17:18] in set("WVu")]
        assert defined
        assert [s for s in defined if "Avx" not in s and not s.startswith(("DW.ref.", "typeinfo"))] == [], file.name


def test_every_header_compiles_alone(build):
    flags = compile_flags(build)

    def errors(header):
        folder = next(f for f in header.parents if f in flags)  # a folder of headers only uses that above
        command = [*flags[folder], *instruction_sets(header), "-fsyntax-only", "-x", "c++", "-"]
        done = subprocess.run(command, input=f'#include "{name(header)}"\n', cwd=build, capture_output=True, text=True, check=False)
        return done.stderr

    headers = [header for header in sources("*.hpp") if not comes_first_in_its_source(header)]
    with ThreadPoolExecutor(cpu_count()) as pool:
        found = dict(zip(map(name, headers), pool.map(errors, headers)))
    assert found
    assert {header: error for header, error in found.items() if error} == {}


def code_of(file):
    """A file without its comments."""
    return re.sub(r"//[^\n]*|/\*.*?\*/", "", file.read_text(), flags=re.DOTALL)


def test_device_code_only_instantiates():
    """The step and the physics exist once: kernels run whatever body they are given, translation units of nvcc name types."""
    units = [f for f in sources("*.cu") if folder_of(f.relative_to(ROOT)) == "solver/engine"]
    assert units
    for unit in units:
        code = code_of(unit)
        assert not re.search(r"__global__|<<<|\bfor\b|\bwhile\b|[^/]\*\s*\w|\+=", code), f"{name(unit)} computes something"
    kernels = {name(f) for f in sources("*.hpp", "*.cuh", "*.cpp", "*.cu") if "__global__" in code_of(f)}
    assert {Path(file).parent for file in kernels} == {Path("solver/execution")}


def test_device_check_sees_a_loop():
    assert re.search(r"\bfor\b", code_of(ROOT / "solver/execution/cuda_kernels.cuh"))
