"""Cases that share a GPU."""

import re

import pytest
import yaml
from test_dag import change, dry_run, planned

REDUCED = "config/reduced.yaml"


def sweep_commands(workflow, doubles, config):
    code, output = workflow("--dry-run", "--printshellcmds", "--configfile", config, build=doubles)
    assert code == 0, output
    return sorted(re.findall(r"recoat-solve (sweep .*)", output)), re.findall(r"recoat-solve (run .*)", output)


def test_without_gpus_each_case_is_a_job_of_its_own(workflow, doubles):
    output = dry_run(workflow, doubles, REDUCED)
    assert planned(output, "simulate_layer") == 6 and planned(output, "simulate_fill") == 4
    assert not any(planned(output, rule) for rule in ("sweep_file", "sweep", "collect_layer", "collect_fill"))
    sweeps, runs = sweep_commands(workflow, doubles, REDUCED)
    assert not sweeps and len(runs) == 10
    assert all("--backend auto" in command for command in runs)


@pytest.mark.parametrize("size, sweeps", [(1, 10), (4, 3), (5, 3), (6, 2), (100, 2)])
def test_with_gpus_cases_of_one_kind_share_a_job(workflow, doubles, size, sweeps):
    change(workflow, "reduced", gpus=1, cases_per_gpu=size)
    output = dry_run(workflow, doubles, REDUCED)
    assert planned(output, "sweep") == planned(output, "sweep_file") == sweeps
    assert planned(output, "collect_layer") == 6 and planned(output, "collect_fill") == 4
    assert planned(output, "simulate_layer") == planned(output, "simulate_fill") == 0
    assert planned(output, "derive") == planned(output, "analyze_bed") == 10


def test_sweeps_take_the_devices_in_turn(workflow, doubles):
    change(workflow, "reduced", gpus=1, devices=[2, 5], solver_threads=3)
    sweeps, runs = sweep_commands(workflow, doubles, REDUCED)
    assert not runs
    assert [re.sub(r"results\S*/| [12]?>.*", "", command) for command in sweeps] == [
        "sweep fills-1.yaml --overwrite --threads 3 --backend cuda --device 2",
        "sweep layers-1.yaml --overwrite --threads 3 --backend cuda --device 2",
        "sweep layers-2.yaml --overwrite --threads 3 --backend cuda --device 5",
    ]


@pytest.mark.parametrize("gpus", [0, 1])
def test_the_backend_is_passed_on(workflow, doubles, gpus):
    change(workflow, "reduced", gpus=gpus, backend="cpu")
    sweeps, runs = sweep_commands(workflow, doubles, REDUCED)
    assert bool(sweeps) != bool(runs) and all("--backend cpu" in command for command in sweeps + runs)


def test_a_job_asks_for_its_gpus_and_a_core_for_each_case(workflow, doubles):
    change(workflow, "reduced", gpus=1, cases_per_gpu=2)
    target = "results/reduced/sweeps/layers-1.txt"
    code, output = workflow("--dry-run", target, "--configfile", REDUCED, build=doubles)
    assert code == 0, output
    assert "Running the sweep layers-1 (threads: 2, gpu: 1)" in output


def test_lint_is_clean_with_gpus(workflow, doubles):
    change(workflow, "reduced", gpus=1)
    code, output = workflow("--lint", "--configfile", REDUCED, build=doubles)
    assert code == 0 and "good condition" in output, output


def smoke_layers(workflow):
    return workflow.folder / "results/smoke/layers"


def collect(workflow, doubles):
    """Run all layers of the smoke grid; the rules that ran."""
    bonds, ratios = (5, 50), ("0.01", "0.001")
    targets = [f"results/smoke/layers/bond-{b}_ratio-{r}_seed-1/spread.vtkhdf" for b in bonds for r in ratios]
    code, output = workflow(*targets, "--configfile", "config/smoke.yaml", build=doubles)
    assert code == 0, output
    return {rule: planned(output, rule) for rule in ("sweep_file", "sweep", "collect_layer") if planned(output, rule)}


def test_a_sweep_makes_the_files_of_its_cases(workflow, doubles):
    change(workflow, "smoke", gpus=1, cases_per_gpu=3)
    assert collect(workflow, doubles) == {"sweep_file": 2, "sweep": 2, "collect_layer": 4}
    for case in smoke_layers(workflow).iterdir():
        names = ["fill.vtkhdf", "heap.vtkhdf", "spread.vtkhdf", "summary.json"]
        assert sorted(file.name for file in case.iterdir() if file.suffix in (".vtkhdf", ".json") and file.name != "derived.json") == names
        for name in names:
            assert (case / name).samefile(case / "run" / name)
    sweeps = workflow.folder / "results/smoke/sweeps"
    content = yaml.safe_load((sweeps / "layers-1.yaml").read_text())
    assert (sweeps / content["scene"]).samefile(workflow.folder / "config/scene.yaml")
    assert [(sweeps / case["out"]).resolve() for case in content["cases"]] == [
        (smoke_layers(workflow) / f"bond-{name}_seed-1/run").resolve()
        for name in ("5_ratio-0.01", "5_ratio-0.001", "50_ratio-0.01")
    ]
    assert "cohesion.bond_number=5" in content["cases"][0]["set"]
    assert (sweeps / "layers-2.txt").read_text().count("finished") == 1
    assert collect(workflow, doubles) == {}


def test_a_change_of_one_case_simulates_that_case_only(workflow, doubles):
    change(workflow, "smoke", gpus=1)
    collect(workflow, doubles)
    steps = [
        {"stiffness_ratio": 0.001, "largest_bond_number": 10, "time_step": "5e-8 s"},
        {"stiffness_ratio": 0.001, "time_step": "1e-7 s"},
        {"stiffness_ratio": 0.01, "time_step": "1e-7 s"},
    ]
    change(workflow, "smoke", time_steps=steps)
    assert collect(workflow, doubles) == {"sweep_file": 1, "sweep": 1, "collect_layer": 4}
    for case in smoke_layers(workflow).iterdir():
        assert (case / "spread.vtkhdf").samefile(case / "run/spread.vtkhdf")
    report = (workflow.folder / "results/smoke/sweeps/layers-1.txt").read_text()
    assert report.count("already finished") == 3
    assert collect(workflow, doubles) == {}


def test_a_lost_file_is_linked_again_without_a_sweep(workflow, doubles):
    change(workflow, "smoke", gpus=1)
    collect(workflow, doubles)
    (smoke_layers(workflow) / "bond-5_ratio-0.001_seed-1/spread.vtkhdf").unlink()
    assert collect(workflow, doubles) == {"collect_layer": 1}
