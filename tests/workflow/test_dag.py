"""What the workflow would do, without doing it."""

import re

import pytest
import yaml


def planned(output, rule):
    """Number of jobs of a rule in the statistics of a dry run."""
    found = re.search(rf"^{rule}\s+(\d+)$", output, re.MULTILINE)
    return int(found.group(1)) if found else 0


def dry_run(workflow, doubles, config):
    code, output = workflow("--dry-run", "--quiet", "rules", "--configfile", config, build=doubles)
    assert code == 0, output
    return output


@pytest.mark.parametrize(
    "grid, layers, fills, figures",
    [("reduced", 6, 4, 13), ("smoke", 4, 0, 14), ("paper", 15, 0, 14)],
)
def test_every_grid_is_planned(workflow, doubles, grid, layers, fills, figures):
    output = dry_run(workflow, doubles, f"config/{grid}.yaml")
    assert planned(output, "simulate_layer") == layers
    assert planned(output, "simulate_fill") == fills
    assert planned(output, "analyze_layer") == layers
    assert planned(output, "analyze_bed") == layers + fills
    assert planned(output, "figure") == figures


def test_reduced_grid_is_the_default(workflow, doubles):
    code, output = workflow("--dry-run", "--quiet", "rules", build=doubles)
    assert code == 0 and planned(output, "simulate_layer") == 6, output


def test_seeds_multiply_the_cases(workflow, doubles):
    change(workflow, "smoke", seeds=[1, 2, 3])
    assert planned(dry_run(workflow, doubles, "config/smoke.yaml"), "simulate_layer") == 12


def test_lint_is_clean(workflow, doubles):
    for grid in ("reduced", "paper"):
        code, output = workflow("--lint", "--configfile", f"config/{grid}.yaml", build=doubles)
        assert code == 0 and "good condition" in output, output


def change(workflow, grid, **values):
    """Change top-level keys of a grid's configuration; None removes a key."""
    path = workflow.folder / f"config/{grid}.yaml"
    config = yaml.safe_load(path.read_text()) | values
    path.write_text(yaml.safe_dump({key: value for key, value in config.items() if value is not None}))


@pytest.mark.parametrize(
    "values, sentence",
    [
        ({"bond_numbers": [5]}, "config/smoke.yaml: bond_numbers: the key is unknown; remove it or use one of "),
        ({"seed": [5]}, 'config/smoke.yaml: seed: the key is unknown; did you mean "seeds"?'),
        ({"layers": [{"bond_numbrs": [5], "stiffness_ratios": [1]}]}, 'layers.0.bond_numbrs: the key is unknown; did you mean "bond_numbers"?'),
        ({"seeds": []}, "[] should be non-empty"),
        ({"layers": None}, "'layers' is a required property"),
        ({"layers": [{"bond_numbers": [-5], "stiffness_ratios": [0.001]}]}, "-5 is less than the minimum of 0"),
        ({"layers": [{"bond_numbers": ["high"], "stiffness_ratios": [0.001]}]}, "'high' does not match"),
        ({"time_steps": [{"stiffness_ratio": 0.001, "time_step": "soon"}]}, "'soon' does not match"),
    ],
)
def test_bad_grid_is_refused(workflow, doubles, values, sentence):
    change(workflow, "smoke", **values)
    code, output = workflow("--dry-run", "--configfile", "config/smoke.yaml", build=doubles)
    assert code != 0 and sentence in output, output
    assert len(output.splitlines()) < 6 and "schema" not in output, output


def test_a_bad_scene_of_a_grid_is_refused_in_one_sentence(workflow, doubles):
    change(workflow, "smoke", scene="config/wrong.yaml")
    scene = yaml.safe_load((workflow.folder / "config/scene.yaml").read_text())
    scene["blade"]["clearence"] = scene["blade"].pop("clearance")
    (workflow.folder / "config/wrong.yaml").write_text(yaml.safe_dump(scene))
    code, output = workflow("--dry-run", "--configfile", "config/smoke.yaml", build=doubles)
    assert code != 0 and 'config/wrong.yaml: blade.clearence: the key is unknown; did you mean "clearance"?' in output, output
    assert len(output.splitlines()) < 6, output


def test_case_without_a_time_step_takes_the_automatic_one(workflow, doubles):
    steps = [{"stiffness_ratio": 0.001, "largest_bond_number": 1, "time_step": "1e-7 s"}]
    layers = [{"bond_numbers": [1, 5], "stiffness_ratios": [0.001]}]
    change(workflow, "smoke", layers=layers, fills=None, time_steps=steps)
    code, output = workflow("--dry-run", "--printshellcmds", "--configfile", "config/smoke.yaml", build=doubles)
    assert code == 0, output
    runs = [line for line in output.splitlines() if "recoat-solve run" in line]
    chosen = {bond: {line.split("time_step=")[1].split()[0].strip("'") for line in runs if f"bond_number={bond}" in line} for bond in (1, 5)}
    assert chosen == {1: {"1e-7"}, 5: {"auto"}}


def test_one_number_written_in_two_ways_is_one_case(workflow, doubles):
    layers = [
        {"bond_numbers": ["5e0"], "stiffness_ratios": ["1e-3"]},
        {"bond_numbers": [5.0], "stiffness_ratios": [0.001]},
    ]
    change(workflow, "smoke", layers=layers)
    assert planned(dry_run(workflow, doubles, "config/smoke.yaml"), "simulate_layer") == 1


def test_fill_cases_stop_after_the_fill_stage_and_reuse_full_runs(workflow, doubles):
    code, output = workflow("--dry-run", "--printshellcmds", "--configfile", "config/reduced.yaml", build=doubles)
    commands = [line for line in output.splitlines() if "recoat-solve run" in line]
    fills = [line for line in commands if "/fills/" in line]
    assert code == 0 and len(commands) == 10 and len(fills) == 4
    assert not any("stiffness_ratio=0.001" in line for line in fills)
    for line in fills:
        assert "stages=[{fill: " in line and "heap" not in line and "stages.spread" not in line
    for line in set(commands) - set(fills):
        assert "stages=" not in line and "stages.spread.length=" in line
