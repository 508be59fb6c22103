"""The scenes and runs of `make bench` and `make bench-against`; how fast anything is, is not tested."""

import json
import subprocess
import sys
import time

import pytest


@pytest.fixture(scope="module")
def files(speed, tmp_path_factory):
    scenes = speed("scenes")
    return scenes.prepare(tmp_path_factory.mktemp("scenes"), [scene for scene in scenes.SOURCES if scene != "large_bed"])


@pytest.fixture(scope="module")
def today(speed, build):
    return speed("recoat").Build("today", build)


def test_copies_of_a_bed_lie_side_by_side(speed):
    one, ten = (speed("scenes").read_particles(scene) for scene in ("bed", "large_bed"))
    assert len(ten) == 10 * len(one)
    assert ten[len(one)][0] == one[0][0] and ten[len(one)][1] == pytest.approx(one[0][1] + 1e-3)
    assert 9e-3 < max(row[1] for row in ten) <= 10e-3


def test_both_programs_read_each_scene(files, today):
    for scene, file in files.items():
        result = today.rate(file, 0, 1, 1, 2)
        assert result["particles"] == 10_000 and result["rate"] > 0 and result["processor_rate"] > 0, scene
        check = subprocess.run([today.solver, "run", file, "--print-config"], capture_output=True, text=True, check=False)
        assert check.returncode == 0, check.stderr


def test_a_bed_is_denser_in_contacts_than_a_heap_than_a_layer(files, today):
    contacts = {scene: today.rate(file, 0, 1, 20, 2)["coordination"] for scene, file in files.items()}
    assert contacts["bed"] == pytest.approx(4.5, abs=0.2) and 1.5 < contacts["heap"] < 3 and contacts["layer"] < 0.7
    assert contacts["bed_unequal"] == pytest.approx(contacts["bed"], abs=0.1)
    assert contacts["bed_without_walls"] < contacts["bed"] + 0.1


def test_radii_that_differ_take_the_way_of_unequal_sizes(speed):
    assert len({row[3] for row in speed("scenes").read_particles("bed_unequal")}) == 2


def test_unknown_settings_are_not_available(files, today):
    assert today.accepts(files["bed"], ("stiffness_ratio=0.01",))
    assert not today.accepts(files["bed"], ("no_such_key=1",))
    assert today.rate(files["bed"], 0, 1, 1, 2, ["no_such_key=1"]) is None


def test_loops_for_less_than_the_machine_has_can_be_measured(files, today):
    assert today.instruction_set() in ("baseline", "avx2", "avx512")
    assert today.rate(files["bed"], 0, 1, 1, 2, instruction_set="baseline")["rate"] > 0
    with pytest.raises(RuntimeError, match="RECOAT_INSTRUCTION_SET"):
        today.rate(files["bed"], 0, 1, 1, 2, instruction_set="no-such-set")


def test_a_run_that_fails_is_told(today):
    with pytest.raises(RuntimeError, match="no-such-scene"):
        today.rate("no-such-scene.yaml", 0, 1, 1, 2)


def test_others_that_keep_a_core_busy_are_seen(speed):
    idle = [sys.executable, "-c", "import time; time.sleep(0.3)"]
    spin = "import time; end = time.monotonic() + 0.6\nwhile time.monotonic() < end: pass"
    with subprocess.Popen([sys.executable, "-c", spin]):
        assert speed("measuring").run(idle).others > 0.2


def test_processor_time_of_a_command_is_its_own(speed):
    spin = "import time; end = time.process_time() + 0.3\nwhile time.process_time() < end: pass"
    done = speed("measuring").run([sys.executable, "-c", spin])
    assert done.code == 0 and 0.3 <= done.processor < 0.6


def test_what_takes_too_long_is_ended_with_its_children(speed, tmp_path):
    late = tmp_path / "late"
    done = speed("measuring").run(["sh", "-c", f"(sleep 1; touch {late}) & wait"], timeout=0.2)
    assert done.code == 124 and done.wall < 1
    time.sleep(1.2)
    assert not late.exists()


def test_a_program_that_is_missing_is_told(speed):
    done = speed("measuring").run(["no-such-program"])
    assert done.code == 127 and "no-such-program" in done.errors


def test_against_writes_ratios(root, build, tmp_path):
    out = tmp_path / "against.json"
    command = [sys.executable, root / "bench/speed/against.py", build, "--build", build, "--scenes", "bed", "--bonds", "0"]
    subprocess.run([*command, "--shorten", "200", "--repeats", "2", "--out", out], check=True, capture_output=True)
    (row,) = json.loads(out.read_text())["rows"]
    assert row["scene"] == "bed" and 0.2 < row["processor_rate"]["ratio"]["median"] < 5


def test_an_interrupted_journal_goes_on(speed, tmp_path):
    file = tmp_path / "journal.jsonl"
    journal = speed("journal").Journal(file)
    journal.once("a", lambda: {"rate": 1})
    with file.open("a") as stream:
        stream.write('{"key": "b", "rec')
    again, made = speed("journal").Journal(file), []
    assert again.once("a", lambda: made.append("a")) == {"rate": 1}
    again.once("b", lambda: made.append("b") or {"rate": 2})
    assert made == ["b"] and speed("journal").Journal(file).records["b"] == {"rate": 2}


def test_a_failure_is_kept_beside_the_others(speed, tmp_path):
    def fail():
        raise RuntimeError("no such style")

    assert speed("journal").Journal(tmp_path / "journal.jsonl").once("a", fail) == {"failed": "no such style"}
