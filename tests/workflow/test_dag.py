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
    [("reduced", 6, 4, 15), ("smoke", 4, 0, 17), ("workstation", 26, 0, 17), ("paper", 15, 0, 17)],
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
    for grid in ("reduced", "workstation", "paper"):
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
        ({"bond_numbers": [5]}, "bond_numbers: there is no such key"),
        ({"seed": [1]}, "seed: there is no such key; did you mean seeds?"),
        ({"layers": [{"bond_nubmers": [5], "stiffness_ratios": [1]}]}, "layers[0].bond_nubmers: there is no such key; did you mean bond_numbers?"),
        ({"bounds": {"overlap": 1}}, "bounds.overlap: there is no such key; did you mean largest_overlap?"),
        ({"seeds": []}, "seeds: [] should be non-empty"),
        ({"layers": None}, "the key layers is missing"),
        ({"layers": [{"bond_numbers": [-5], "stiffness_ratios": [0.001]}]}, "layers[0].bond_numbers[0]: -5 is less than the minimum of 0"),
        ({"layers": [{"bond_numbers": ["high"], "stiffness_ratios": [0.001]}]}, "layers[0].bond_numbers[0]: \"high\" is not possible here (A number"),
        ({"time_steps": [{"stiffness_ratio": 0.001, "time_step": "soon"}]}, "time_steps[0].time_step: \"soon\" is not possible here"),
        ({"gpus": "one"}, "gpus: 'one' is not of type 'integer'"),
    ],
)  # fmt: skip
def test_bad_grid_is_refused_with_one_sentence(workflow, doubles, values, sentence):
    change(workflow, "smoke", **values)
    code, output = workflow("--dry-run", "--quiet", "all", "--configfile", "config/smoke.yaml", build=doubles)
    said = [line for line in output.splitlines() if line.startswith("recoat:")]
    assert code == 2 and len(said) == 1 and sentence in said[0], output
    assert said[0].startswith("recoat: config/smoke.yaml, line ") and len(said[0]) < 300
    assert "Traceback" not in output and "jsonschema" not in output


def test_the_line_of_a_misspelt_key_is_told(workflow, doubles):
    path = workflow.folder / "config/smoke.yaml"
    lines = path.read_text().splitlines()
    number = next(k for k, line in enumerate(lines) if "bond_numbers" in line)
    lines[number] = lines[number].replace("bond_numbers", "bond_number")
    path.write_text("\n".join(lines))
    code, output = workflow("--dry-run", "--configfile", "config/smoke.yaml", build=doubles)
    assert code == 2 and f"config/smoke.yaml, line {number + 1}: layers[0].bond_number: " in output, output


def test_a_misspelt_option_of_the_command_line_is_told(workflow, doubles):
    code, output = workflow("--dry-run", "--configfile", "config/smoke.yaml", "--config", "gpu=1", f"build_directory={doubles}")
    assert code == 2 and "recoat: --config: gpu: there is no such key; did you mean gpus?" in output, output


def test_a_misspelt_key_of_the_scene_is_told(workflow, doubles):
    path = workflow.folder / "config/scene.yaml"
    path.write_text(path.read_text().replace("clearance:", "clearence:"))
    code, output = workflow("--dry-run", "--configfile", "config/smoke.yaml", build=doubles)
    assert code == 2 and "config/scene.yaml, line" in output and "did you mean clearance?" in output, output


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
