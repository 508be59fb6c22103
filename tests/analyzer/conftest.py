"""How the Python tests of the analyser call the program."""

import resource
import subprocess

import pytest

MOST_MEMORY = 4 << 30  # bytes of address space, most of it never touched


@pytest.fixture
def analyze(build, tmp_path):
    """Runs the program in an empty folder."""

    def run(*arguments):
        command = [build / "analyzer/recoat-analyze", *map(str, arguments)]
        limit = lambda: resource.setrlimit(resource.RLIMIT_AS, (MOST_MEMORY, MOST_MEMORY))
        return subprocess.run(command, cwd=tmp_path, capture_output=True, text=True, check=False, timeout=60, preexec_fn=limit)

    return run


@pytest.fixture
def good(analyze):
    """Runs the program, which must succeed."""

    def run(*arguments):
        done = analyze(*arguments)
        assert done.returncode == 0, done.stderr
        return done.stdout

    return run


@pytest.fixture
def refused(analyze, tmp_path):
    """The one sentence of a refusal, which leaves nothing behind."""

    def run(*arguments):
        before = set(tmp_path.iterdir())
        done = analyze(*arguments)
        assert done.returncode == 2, done.stdout + done.stderr
        assert set(tmp_path.iterdir()) == before
        assert len(done.stderr.splitlines()) == 1
        return done.stderr

    return run
