"""A copy of the workflow in a temporary folder, and made-up cases."""

import os
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

HERE = Path(__file__).resolve().parent
ROOT = HERE.parents[1]
sys.path[:0] = [str(HERE), str(ROOT / "workflow/scripts")]


class Workflow:
    """The workflow with its configurations in a folder of its own."""

    def __init__(self, folder):
        self.folder = folder
        shutil.copy(ROOT / "Snakefile", folder)
        for name in ("workflow", "config"):
            shutil.copytree(ROOT / name, folder / name)

    def __call__(self, *options, build=None):
        """Run Snakemake; its exit code with its output as text."""
        settings = ["--config", f"build_directory={build}"] if build else []
        process = self.start(*options, *settings, environment=os.environ)
        output, _ = process.communicate()
        return process.returncode, output

    def start(self, *options, environment, output=subprocess.PIPE):
        """Start Snakemake and do not wait for it."""
        environment = {**environment, "PATH": f"{Path(sys.executable).parent}:{environment['PATH']}"}
        command = [sys.executable, "-m", "snakemake", "--cores", "2", *options]
        return subprocess.Popen(
            command, cwd=self.folder, env=environment, stdout=output, stderr=subprocess.STDOUT, text=True
        )


@pytest.fixture
def workflow(tmp_path):
    return Workflow(tmp_path)


@pytest.fixture(scope="session")
def new_workflow(tmp_path_factory):
    """Makes further copies of the workflow, which outlive a test."""
    return lambda: Workflow(tmp_path_factory.mktemp("workflow"))


@pytest.fixture(scope="session")
def doubles(tmp_path_factory):
    """A build folder whose programs make up their results."""
    folder = tmp_path_factory.mktemp("doubles")
    for part, program in (("solver", "recoat-solve"), ("analyzer", "recoat-analyze")):
        (folder / part).mkdir()
        launcher = folder / part / program
        launcher.write_text(f'#!/bin/sh\nexec {sys.executable} {HERE / "doubles" / program} "$@"\n')
        launcher.chmod(0o755)
    return folder
