"""Builds the programs of another commit beside today's, with today's step-rate."""

import os
import shutil
import subprocess
from pathlib import Path

from machine import ROOT, commit
from measuring import run

# Overlaid on the other commit, so that both are measured alike.
MEASURED_BY = ("bench/step_rate.cpp",)
TARGETS = ("step-rate", "recoat-solve")


def built(revision, cores, targets=TARGETS):
    """Build folder of `revision`; it is made in build/against, in a folder of that commit's sources, unless it is there."""
    name = commit(revision)
    folder = ROOT / "build/against" / name
    build = folder / "build/release"
    if not (folder / "unpacked").exists():
        unpack(name, folder)
        (folder / "unpacked").touch()
    overlay(folder)
    compile_programs(folder, build, cores, targets)
    return build


def unpack(name, folder):
    """The sources of a commit, without its history."""
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    archive = folder.with_suffix(".tar")
    for command in (["git", "archive", "--output", archive, name], ["tar", "-xf", archive, "-C", folder]):
        subprocess.run(command, cwd=ROOT, check=True)
    archive.unlink()


def overlay(folder):
    for name in MEASURED_BY:
        source, target = ROOT / name, folder / name
        if not target.exists() or target.read_bytes() != source.read_bytes():
            shutil.copy(source, target)


def compile_programs(folder, build, cores, targets):
    """Builds the programs; says what the compiler said where it fails."""
    cmake = ["cmake", "--preset", "release", "--log-level=WARNING", "-DRECOAT_TESTS=OFF", "-DRECOAT_CUDA=OFF"]
    make = ["cmake", "--build", build, "--parallel", cores, "--target", *targets]
    for command in ([] if (build / "build.ninja").exists() else [cmake]) + [make]:
        done = run(command, cwd=folder, env=apart(folder))
        if done.code != 0:
            last = "\n".join((done.output + done.errors).splitlines()[-15:])
            raise SystemExit(f"{folder.name} cannot be built with {', '.join(MEASURED_BY)} of today:\n{last}")


def apart(folder):
    """Keeps git from taking the commit of the repository around `folder` for that of its sources."""
    return os.environ | {"GIT_CEILING_DIRECTORIES": str(folder.parent), "CCACHE_BASEDIR": str(folder), "CCACHE_NOHASHDIR": "1"}
