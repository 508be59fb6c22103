"""Runs one small bed or layer and measures it: processor time of the solver, steps, energy balance, metrics."""

import json
import resource
import shutil
import subprocess
import sys
from pathlib import Path

from workflow_scripts import Clock, bed_region, layer_region, read_state, solver_version, write_json

ANALYSIS = {"voxels_per_dp": [], "bootstrap_resamples": 0, "chamber_min_diameter": 0.5}  # pores: metrics.md


def fill_only(scene, overrides):
    """The overrides of a run that ends with the fill stage."""
    later = ("stages.heap", "stages.spread")
    kept = {key: value for key, value in overrides.items() if not key.startswith(later)}
    energy = kept.pop("stages.fill.settle_energy")
    return {"stages": f"[{{fill: {{settle_energy: {energy}, settle_time: 200 ms}}}}]"} | kept


def solve(build, scene, overrides, folder):
    """Exit code, last sentence and processor seconds of the solver."""
    settings = [part for key, value in overrides.items() for part in ("--set", f"{key}={value}")]
    command = [f"{build}/solver/recoat-solve", "run", scene, "--out", folder, "--overwrite", "--quiet"]
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    run = subprocess.run(
        command + ["--threads", "1", "--backend", "cpu"] + settings, capture_output=True, text=True, check=False
    )
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    seconds = after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime
    return run.returncode, (run.stderr.strip().splitlines() or [""])[-1], seconds


def analyze(build, state, region, folder):
    """The metrics of recoat-analyze for a state."""
    config, out = folder / "region.json", folder / "metrics.json"
    write_json(config, region | ANALYSIS)
    subprocess.run(
        [f"{build}/analyzer/recoat-analyze", "metrics", state, "--config", config, "--json", out],
        check=True,
        capture_output=True,
    )
    return json.loads(out.read_text())


def bed_quantities(build, folder):
    """Of the bed between blade and gate: global packing density [paper, eq. 14] and mean coordination number."""
    state = folder / "fill.vtkhdf"
    metrics = analyze(build, state, bed_region(read_state(state), []), folder)
    return {
        "bed packing density": metrics["totals"]["eq14_clipped"],
        "bed coordination number": metrics["clusters"]["cn_mean"],
    }


def layer_quantities(build, folder, skips):
    """Of the spread layer."""
    state = folder / "spread.vtkhdf"
    metrics = analyze(build, state, layer_region(read_state(state), *skips, {}), folder)
    return {
        "median packing density": metrics["phi_exact"]["median"],
        "IQR/median": metrics["phi_exact"]["iqr_over_median"],
        "roughness Ra [d_p]": metrics["height"]["Ra"],
        "layer packing density": metrics["totals"]["layer_phi"],
        "coordination number": metrics["clusters"]["cn_mean"],
        "share of empty nodes": metrics["height"]["empty_fraction"],
        "mean chamber pore [d_p]": metrics["chamber_pores"]["A"]["mean"],
    }


def balance_error(energy):
    """Error of the energy balance of a stage as a share of the work of walls, or else of the dissipated energy."""
    return energy["balance_error"] / (abs(energy["wall_work"]) or abs(energy["dissipated"]) or 1)


def measure(build, scene, run, folder):
    """The record of one run."""
    bed = run["kind"] == "bed"
    overrides = fill_only(scene, run["overrides"]) if bed else run["overrides"]
    code, sentence, seconds = solve(build, scene, overrides, folder)
    outcome = {"exit_code": code, "sentence": sentence, "processor_seconds": seconds}
    record = run["about"] | {"version": solver_version(build)} | outcome
    if code not in (0, 2, 3):
        sys.exit(f"recoat-solve ended with {code}: {sentence}")
    if code != 0:
        return record
    summary = json.loads((folder / "summary.json").read_text())
    stages = summary["stages"]
    quantities = bed_quantities(build, folder) if bed else layer_quantities(build, folder, run["region"])
    return record | {
        "particles": summary["particles"],
        "steps": sum(stage["steps"] for stage in stages),
        "simulated_seconds": sum(stage["time"] for stage in stages),
        "largest_overlap": max(stage["largest_overlap"] for stage in stages),
        "energy_balance_error": balance_error(stages[-1]["energy"]),
        "quantities": quantities,
    }


if __name__ == "__main__":
    params = snakemake.params
    work = Path(params.folder)
    work.mkdir(parents=True, exist_ok=True)
    clock = Clock()
    record = measure(params.build, params.scene, params.run, work)
    write_json(snakemake.output[0], clock.record() | record)  # processor seconds are those of the solver alone
    shutil.rmtree(work)
