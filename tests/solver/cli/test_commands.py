"""Exit codes and sentences of recoat-solve, and what it prints."""

import json
import os
import subprocess
import time
from pathlib import Path

import pytest
import yaml


def test_version_names_the_program(solver):
    assert solver.good("--version").startswith("recoat-solve 0.")


def test_without_a_command_it_explains_itself(solver):
    result = solver()
    assert result.returncode == 2
    assert "subcommand" in result.stderr


def test_help_lists_the_commands(solver):
    text = solver.good("--help")
    assert all(command in text for command in ("run", "resume", "check", "models"))


def test_models_lists_every_option_of_the_schema(solver, root):
    schema = json.loads((root / "config/schema/scene.schema.json").read_text())
    text = solver.good("models")
    named = 0
    for section in ("contact", "cohesion"):
        for key, value in schema["$defs"][section]["properties"].items():
            if "enum" not in value and value.get("type") != "boolean":
                continue
            named += 1
            assert f"{section}.{key}: " in text
            for word in value.get("enum", ["true", "false"]):
                assert f"  {word} " in text
    assert named == 9


def test_print_config_is_whole_and_reads_back(solver):
    text = solver.good("run", "spread.yaml", "--print-config", "--set", "cohesion.bond_number=7")
    config = yaml.safe_load(text)
    assert config["cohesion"]["bond_number"] == 7
    assert config["cohesion"]["scheme"] == "discrete_gradient"
    assert config["contact"]["rolling_form"] == "own"
    solver.write("again.yaml", text)
    assert solver.good("run", "again.yaml", "--print-config") == text


@pytest.mark.parametrize(
    "old, new, expected",
    [
        ("diameter: 50 um", "diameter: 50", ["spread.yaml:", "material.diameter", "unit"]),
        ("restitution: 0.4", "restitutoin: 0.4", ["restitutoin", "restitution"]),
        ("restitution: 0.4", "restitution: 1.4", ["contact.restitution", "at most 1"]),
        ("bond_number: 5", "bond_number: 5, hamaker: 1e-20 J", ["cohesion.hamaker", "either"]),
        ("time_step: 1e-7 s", "time_step: 1e-5 s", ["time_step", "stability limit"]),
        ("  - heap", "  - heep", ["stages", "a stage is one of"]),
        ("clearance: 1.5 dp", "clearence: 1.5 dp", ["clearence", "clearance"]),
        ("scene: spread", "scene: spred", ["scene", "spread"]),
        ("powder: {particles: 40}", "powder: {particles: 40", ["spread.yaml:"]),
    ],
)
def test_bad_scenes_get_one_sentence_with_the_place(solver, old, new, expected):
    text = (solver.folder / "spread.yaml").read_text()
    assert old in text
    solver.write("spread.yaml", text.replace(old, new))
    for command in (["check", "spread.yaml"], ["run", "spread.yaml", "--out", "out"]):
        sentence = solver.refusal(*command)
        for words in expected:
            assert words in sentence
    assert not (solver.folder / "out").exists()


def test_errors_in_overrides_name_the_override(solver):
    assert "--set contact.restitution=2" in solver.refusal("check", "spread.yaml", "--set", "contact.restitution=2")


def test_missing_files_are_named(solver):
    assert "nowhere.yaml" in solver.refusal("check", "nowhere.yaml")
    (solver.folder / "table.csv").unlink()
    assert "table.csv" in solver.refusal("run", "particles.yaml", "--out", "out")


def test_a_bad_table_is_refused_with_its_line(solver):
    solver.write("table.csv", "x,y,z,radius,vx,vy,vz,wx,wy,wz\n0,0,26e-6,-1,0,0,0,0,0,0\n")
    assert "table.csv:2: column 4 (radius)" in solver.refusal("run", "particles.yaml", "--out", "out")


def test_run_wants_a_folder_that_it_can_write_to(solver):
    assert "--out" in solver.refusal("run", "spread.yaml")
    solver.write("file", "")
    assert "file" in solver.refusal("run", "particles.yaml", "--out", "file")


def test_nothing_to_resume(solver):
    assert "no checkpoint" in solver.refusal("resume", "nowhere")


def test_check_prints_the_numbers_of_the_paper(solver, root):
    report = json.loads(solver.good("check", root / "config/scene.yaml", "--json"))
    assert report["particles"] == 100000
    assert report["mass"] == pytest.approx(2.899428219876e-10, rel=1e-12)
    assert report["effective_modulus"]["pair"]["original"] == pytest.approx(6.04395604e10, rel=1e-8)
    assert report["effective_modulus"]["wall"]["reduced"] == pytest.approx(6.04395604e7, rel=1e-8)
    assert report["effective_shear_modulus"]["pair"]["original"] == pytest.approx(1.24434389e10, rel=1e-8)
    assert report["hamaker"]["original"] == pytest.approx(1.858491e-22, rel=4e-7)
    assert report["pull_off_force"] == pytest.approx({"pair": 1.422170e-8, "wall": 2.844339e-8}, rel=4e-7)
    assert report["bond_number"] == pytest.approx({"pair": 5, "wall": 10})
    assert report["inertial_length"] == pytest.approx({"paper": 1.415789, "wall": 0.77225}, rel=1e-5)
    limits = {limit["name"]: limit for limit in report["time_step_limits"]}
    assert limits["Rayleigh time"]["limit"] == pytest.approx(8.6834e-7, rel=1e-4)
    assert limits["Rayleigh time"]["share"] == pytest.approx(0.023, abs=5e-4)
    assert limits["contact time at 0.05 m/s"]["limit"] == pytest.approx(4.471e-6, rel=2e-4)
    assert {stage["name"]: stage["steps"] for stage in report["stages"]}["spread"] == 25_000_000 + 75_000 + 25_000_000
    assert report["steps"] == sum(stage["steps"] for stage in report["stages"])
    expected = report["expected"]
    assert expected["particle_steps_per_second"] > 1e4
    assert expected["seconds"] == pytest.approx(1e5 * report["steps"] / expected["particle_steps_per_second"])
    assert expected["bytes"] > 1e5 * 80


@pytest.mark.parametrize("bond, printed", [(0, 8.49), (1, 4.24), (5, 1.41), (50, 0.16), (200, 0.04)])
def test_check_gives_the_printed_inertial_lengths(solver, bond, printed):
    report = json.loads(solver.good("check", "spread.yaml", "--json", "--set", f"cohesion.bond_number={bond}",
                                    "--set", "blade.speed=50 mm/s"))
    assert int(100 * report["inertial_length"]["paper"]) / 100 == printed


def test_check_as_text_names_each_limit_with_its_formula(solver):
    text = solver.good("check", "spread.yaml")
    for words in ("Rayleigh time", "pi R sqrt(rho/G)", "contact frequency", "van der Waals", "% of it", "at most",
                  "Hamaker constant A^R", "particle-steps/s", "MiB"):
        assert words in text


@pytest.mark.parametrize(("told", "expected"), [({}, "10000"), ({"GOMP_SPINCOUNT": "5"}, "5"), ({"OMP_WAIT_POLICY": "active"}, None), ({"LD_PRELOAD": "vgpreload"}, None)])
def test_threads_sleep_soon_when_they_wait(solver, told, expected):
    """A thread that waits for one without a processor must not keep its own; what the user sets is left alone."""
    environment = {key: value for key, value in os.environ.items() if key not in ("GOMP_SPINCOUNT", "OMP_WAIT_POLICY")} | told
    command = [solver.program, "run", "spread.yaml", "--out", "out", "--set", "stages.fill.settle_time=10 s", "--set", "stages.fill.settle_energy=1e-30"]
    with subprocess.Popen(command, cwd=solver.folder, env=environment, stderr=subprocess.DEVNULL) as run:
        try:
            while not (solver.folder / "out").exists() and run.poll() is None:
                time.sleep(0.01)
            variables = dict(pair.split("=", 1) for pair in Path(f"/proc/{run.pid}/environ").read_text().split("\0") if "=" in pair)
            assert run.poll() is None and variables.get("GOMP_SPINCOUNT") == expected
        finally:
            run.kill()
