"""bench/gpu.sh with doubles of the programs it calls: what it writes, when, and within which time."""

import json
import os
import signal
import stat
import subprocess
import time

import pytest

PARTS = ["device", "engine_tests", "same_bits", "rates", "sweep", "sanitizer", "case", "analytic_tests"]

TESTS = """
echo "[==========] Running 4 tests from 2 test suites."
echo "[ RUN      ] Faults.Names"
echo "[       OK ] Faults.Names (3 ms)"
echo "[ RUN      ] Varieties/Backends.Agree/1"
echo "[       OK ] Varieties/Backends.Agree/1 (30 ms)"
echo "[ RUN      ] Faults.Skips"
echo "[  SKIPPED ] Faults.Skips (0 ms)"
if [ -n "${FAILING:-}" ]; then
    echo "[ RUN      ] Varieties/Backends.Agree/2"
    echo "[  FAILED  ] Varieties/Backends.Agree/2, where GetParam() = Bo 50 (12 ms)"
    echo "[  FAILED  ] 1 test, listed below:"
    echo "[  FAILED  ] Varieties/Backends.Agree/2, where GetParam() = Bo 50"
    exit 1
fi
"""

RATE = """
hash=00ff
[ -n "${TWO_HASHES:-}" ] && hash=$$
echo "{\\"particles\\": 1000000, \\"steps\\": 400, \\"particle_steps_per_second\\": 1e9, \\"state_hash\\": \\"$hash\\"}"
"""

SOLVER = """
[ "$1" = --version ] && echo "recoat-solve 0.1.0 (double)" && exit 0
summary='{
  "version": "0.1.0",
  "config": "a: \\"b\\"",
  "particles": 100000,
  "bond_number": 50.0,
  "status": "stopped",
  "steps": 1234,
  "stages": [
    {
      "steps": 7
    }
  ],
  "wall_seconds": 2.5,
  "threads": 1
}'
case $1 in
sweep) for b in 0 50 200 400; do mkdir -p "$(dirname "$2")/sweep/bond-$b" && echo "$summary" >"$(dirname "$2")/sweep/bond-$b/summary.json"; done ;;
run) while [ "$1" != --out ]; do shift; done && mkdir -p "$2" && echo "$summary" >"$2/summary.json" ;;
esac
"""


class Bench:
    """A folder of programs that note how they were called, and the script."""

    def __init__(self, root, folder):
        self.script, self.out, self.build, self.calls = root / "bench/gpu.sh", folder / "out", folder / "build", folder / "calls"
        self.tools = folder / "tools"
        self.program(self.build / "tests/solver/engine/test_engine", TESTS)
        self.program(self.build / "tests/analytic/test_analytic", TESTS)
        self.program(self.build / "bench/step-rate", RATE)
        self.program(self.build / "solver/recoat-solve", SOLVER)
        self.program(self.tools / "nvidia-smi", "echo 'NVIDIA \"X\", 580.1, 1000 MiB, 9.0, Default, 0, 1980 MHz, 700 W'")
        self.program(self.tools / "compute-sanitizer", "echo '========= ERROR SUMMARY: 0 errors'")

    def program(self, path, body):
        path.parent.mkdir(parents=True, exist_ok=True)
        note = f'echo "{path.name} $* device=${{RECOAT_TEST_DEVICE:-}} backend=${{RECOAT_TEST_BACKEND:-}}" >>{self.calls}\n'
        path.write_text("#!/usr/bin/env bash\n" + note + body)
        path.chmod(path.stat().st_mode | stat.S_IXUSR)

    def start(self, *options, **environment):
        environment = {**os.environ, **environment, "PATH": f"{self.tools}:{os.environ['PATH']}"}
        command = [self.script, self.out, "--build", self.build, *options]
        return subprocess.Popen(command, env=environment, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)

    def run(self, *options, **environment):
        process = self.start(*options, **environment)
        text, _ = process.communicate(timeout=120)
        assert process.returncode == 0, text
        return self.result()

    def result(self):
        return json.loads((self.out / "gpu.json").read_text())

    def wait_for(self, word):
        for _ in range(600):
            if self.calls.exists() and word in self.calls.read_text():
                return
            time.sleep(0.1)
        pytest.fail(f"{word} was never called")


@pytest.fixture
def bench(root, tmp_path):
    return Bench(root, tmp_path)


def test_every_part_is_there_in_order_of_value(bench):
    result = bench.run("--device", "3")
    assert [name for name in result if name in PARTS] == PARTS
    assert result["program"] == "recoat-solve 0.1.0 (double)"
    assert result["engine_tests"] == {
        "exit_code": 0,
        "seconds": result["engine_tests"]["seconds"],
        "passed": 2,
        "skipped": 1,
        "failed": [],
        "timed_out": False,
    }
    assert result["same_bits"]["equal"] is True and result["same_bits"]["particles"] == 1000000
    assert len(result["rates"]["measured"]) == result["rates"]["planned"] == 12
    assert [case["steps"] for case in result["sweep"]["cases"]] == [1234] * 4
    assert set(result["sanitizer"]) == {"memcheck", "racecheck", "initcheck", "synccheck"}
    assert result["case"]["run"]["wall_seconds"] == 2.5
    calls = bench.calls.read_text()
    assert "test_engine  device=3 backend=cuda" in calls and "test_analytic  device=3" in calls
    for line in calls.splitlines():
        if line.startswith(("step-rate", "recoat-solve run", "recoat-solve sweep")):
            assert "--device 3 " in line, line
        if line.startswith("nvidia-smi"):
            assert "-i 3 " in line


def test_rates_are_at_rest_and_moving(bench):
    bench.run()
    speeds = [line.split("--moving ")[1].split()[0] for line in bench.calls.read_text().splitlines() if "--moving" in line]
    assert "0" in speeds and "0.1" in speeds


def test_failed_tests_are_named(bench):
    result = bench.run(FAILING="1")
    assert result["engine_tests"]["failed"] == ["Varieties/Backends.Agree/2"]
    assert result["engine_tests"]["exit_code"] == 1


def test_different_bits_are_seen(bench):
    assert bench.run(TWO_HASHES="1")["same_bits"]["equal"] is False
    bench.program(bench.build / "bench/step-rate", "exit 1")
    result = bench.run()
    assert result["same_bits"]["equal"] is None and result["rates"]["measured"] == []


@pytest.mark.parametrize("number", [signal.SIGTERM, signal.SIGKILL])
def test_what_was_done_before_a_signal_stays(bench, number):
    bench.program(bench.build / "bench/step-rate", "exec sleep 60")
    process = bench.start()
    bench.wait_for("step-rate")
    process.send_signal(number)
    process.communicate(timeout=20)
    result = bench.result()
    assert result["engine_tests"]["passed"] == 2
    assert "rates" not in result
    if number == signal.SIGTERM:
        assert process.returncode == 143 and result["same_bits"]["interrupted"] is True


def test_one_limit_holds_for_all(bench):
    bench.program(bench.build / "bench/step-rate", "exec sleep 60")
    began = time.monotonic()
    result = bench.run("--limit", "4")
    assert time.monotonic() - began < 20
    assert result["same_bits"]["exit_code"] == 124 and result["same_bits"]["equal"] is None
    assert result["sweep"] == "no time was left" and result["analytic_tests"] == "no time was left"


def test_a_missing_program_is_named(bench):
    (bench.build / "bench/step-rate").unlink()
    process = bench.start()
    text, _ = process.communicate(timeout=20)
    assert process.returncode == 2 and "step-rate is missing; make static builds it" in text
