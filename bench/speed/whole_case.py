"""Processor time of a whole case of the paper: steps times rate as `check` predicts, and from the rate of a heap before a
blade at the same time step."""

import json

import yaml
from measuring import run
from scenes import ROOT

CASE = ROOT / "config/scene.yaml"
AUTOMATIC = "time_step=auto"
HOUR = 3600.0


def predicted(build, bond):
    """What `recoat-solve check` says of the case on one core: steps at most, step [s], rate, bytes per particle."""
    done = run([build.solver, "check", CASE, "--json", "--threads", 1, "--backend", "cpu", "--set", AUTOMATIC, "--set", f"cohesion.bond_number={bond:g}"])
    if done.code != 0:
        raise RuntimeError(f"{build.solver} check {CASE}: {done.errors.strip()}")
    report = json.loads(done.output)
    rate = report["expected"]["particle_steps_per_second"]
    particles = report["particles"]
    return {
        "particles": particles,
        "time_step": report["time_step"],
        "steps": report["steps"],
        "spread_steps": round(spreading_time(build, bond) / report["time_step"]),
        "rate": rate,
        "bytes_per_particle": report["expected"]["bytes"] / particles,
        "others": done.others,
    }


def spreading_time(build, bond):
    """Time in which the blade crosses its way, 500 d_p at 50 mm/s in the case as published [s]."""
    done = run([build.solver, "run", CASE, "--print-config", "--set", f"cohesion.bond_number={bond:g}"])
    if done.code != 0:
        raise RuntimeError(f"{build.solver} run {CASE} --print-config: {done.errors.strip()}")
    config = yaml.safe_load(done.output)
    length = next(stage["spread"]["length"] for stage in config["stages"] if "spread" in stage)
    return metres(length, config) / metres(config["blade"]["speed"], config)


def metres(text, config):
    """A length [m] or speed [m/s] of a resolved configuration."""
    value, unit = str(text).split()
    units = {"m": 1.0, "mm": 1e-3, "um": 1e-6, "m/s": 1.0, "mm/s": 1e-3}
    return float(value) * (metres(config["material"]["diameter"], config) if unit == "dp" else units[unit])


def hours(prediction, rate):
    """Processor hours of spreading alone and of all steps at most, at a rate [particle-steps/s]."""
    work = prediction["particles"] / rate / HOUR
    return {"spreading": work * prediction["spread_steps"], "all_stages_at_most": work * prediction["steps"]}
