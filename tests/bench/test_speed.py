"""The scenes and the arithmetic of `make bench`; how fast anything is, is not tested."""

import json
import subprocess
import sys

import pytest


@pytest.fixture(scope="module")
def modules(root):
    """The scripts of bench/speed, which import each other by their plain names."""
    sys.path.insert(0, str(root / "bench/speed"))
    import commits
    import measuring
    import recoat
    import scenes
    import statistics_of_rates

    yield {"commits": commits, "measuring": measuring, "recoat": recoat, "scenes": scenes, "statistics": statistics_of_rates}
    sys.path.remove(str(root / "bench/speed"))


@pytest.fixture(scope="module")
def files(modules, tmp_path_factory):
    small = [scene for scene in modules["scenes"].TABLES if scene != "large_bed"]
    return modules["scenes"].prepare(tmp_path_factory.mktemp("scenes"), small)


def test_copies_of_a_bed_lie_side_by_side(modules):
    one, ten = (modules["scenes"].read_particles(scene) for scene in ("bed", "large_bed"))
    assert len(ten) == 10 * len(one)
    assert ten[len(one)][0] == one[0][0] and ten[len(one)][1] == pytest.approx(one[0][1] + 1e-3)
    assert 9e-3 < max(row[1] for row in ten) <= 10e-3


def test_both_programs_read_each_scene(modules, files, build):
    programs = modules["recoat"].Build("today", build)
    for scene, file in files.items():
        result = programs.rate(file, 0, 1, 1, 2)
        assert result["particles"] == 10_000 and result["rate"] > 0 and result["processor_rate"] > 0, scene
        check = subprocess.run([programs.solver, "run", file, "--print-config"], capture_output=True, text=True, check=False)
        assert check.returncode == 0, check.stderr


def test_a_bed_is_denser_in_contacts_than_a_heap(modules, files, build):
    programs = modules["recoat"].Build("today", build)
    contacts = {scene: programs.rate(file, 0, 1, 20, 2)["coordination"] for scene, file in files.items()}
    assert contacts["bed"] == pytest.approx(4.5, abs=0.2) and 1.5 < contacts["heap"] < 3


def test_unknown_settings_are_not_available(modules, files, build):
    programs = modules["recoat"].Build("today", build)
    assert programs.accepts(files["bed"], ("stiffness_ratio=0.01",))
    assert not programs.accepts(files["bed"], ("no_such_key=1",))
    assert programs.rate(files["bed"], 0, 1, 1, 2, ["no_such_key=1"]) is None


def test_a_run_that_fails_is_told(modules, files, build):
    programs = modules["recoat"].Build("today", build)
    with pytest.raises(RuntimeError, match="no-such-scene"):
        programs.rate("no-such-scene.yaml", 0, 1, 1, 2)


def test_ratios_go_pair_by_pair(modules):
    ratio = modules["statistics"].ratios([2, 4, 9], [1, 2, 3])
    assert ratio == {"median": 2, "least": 2, "largest": 3, "repeats": 3}
    assert modules["statistics"].spread([]) is None


def test_others_that_keep_a_core_busy_are_seen(modules):
    idle = [sys.executable, "-c", "import time; time.sleep(0.3)"]
    spin = "import time; end = time.monotonic() + 0.6\nwhile time.monotonic() < end: pass"
    with subprocess.Popen([sys.executable, "-c", spin]):
        assert modules["measuring"].run(idle).others > 0.2


def test_processor_time_of_a_command_is_its_own(modules):
    spin = "import time; end = time.process_time() + 0.3\nwhile time.process_time() < end: pass"
    done = modules["measuring"].run([sys.executable, "-c", spin])
    assert done.code == 0 and 0.3 <= done.processor < 0.6


def test_what_takes_too_long_is_ended(modules):
    assert modules["measuring"].run(["sleep", "5"], timeout=0.1).code == 124


def test_against_writes_ratios(root, build, tmp_path):
    out = tmp_path / "against.json"
    command = [sys.executable, root / "bench/speed/against.py", build, "--build", build, "--scenes", "bed", "--bonds", "0"]
    subprocess.run([*command, "--shorten", "200", "--repeats", "2", "--out", out], check=True, capture_output=True)
    (row,) = json.loads(out.read_text())["rows"]
    assert row["scene"] == "bed" and 0.2 < row["processor_rate"]["ratio"]["median"] < 5
