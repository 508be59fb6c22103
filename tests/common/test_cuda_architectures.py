"""What RECOAT_CUDA=AUTO compiles for, with doubles of nvidia-smi and nvcc."""

import os
import subprocess

import pytest

LIST = "echo sm_75; echo sm_80; echo sm_86; echo sm_90; echo sm_100a; echo sm_120"


@pytest.fixture
def architectures(root, tmp_path):
    def call(smi, nvcc=LIST):
        for name, body in (("nvidia-smi", smi), ("nvcc", nvcc)):
            program = tmp_path / name
            program.write_text(f"#!/bin/sh\n{body}\n")
            program.chmod(0o755)
        script = tmp_path / "script.cmake"
        script.write_text(
            f"cmake_minimum_required(VERSION 3.25)\ninclude({root}/common/cuda_architectures.cmake)\nset(CMAKE_CUDA_COMPILER {tmp_path}/nvcc)\n"
            'architectures_of_this_machine(found)\nmessage("${found}")\n'
        )
        environment = {**os.environ, "PATH": f"{tmp_path}:{os.environ['PATH']}"}
        done = subprocess.run(["cmake", "-P", script], env=environment, capture_output=True, text=True, check=True)
        return done.stderr.strip()

    return call


def test_without_a_device_it_is_the_oldest_and_its_ptx(architectures):
    assert architectures("echo 'NVIDIA-SMI has failed'; exit 9") == "80"


def test_code_for_every_kind_of_device_present(architectures):
    assert architectures("echo 9.0; echo 8.6; echo 9.0") == "80;90-real;86-real"
    assert architectures("echo 8.0") == "80"


def test_devices_that_are_too_old_or_that_the_compiler_does_not_know(architectures):
    assert architectures("echo 7.5; echo 12.1; echo 10.0") == "80"
    assert architectures("echo 9.0", nvcc="exit 1") == "80"
    assert architectures("echo 'No devices were found'") == "80"
