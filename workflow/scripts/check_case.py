"""Judges one run before anything is drawn from it: every item is a bound, and one broken item stops the workflow."""

import math

import numpy

from reporting import Implausible, logged, read_json, write_json
from states import read_state


def particles_kept(summary, states):
    """Every particle of the run is in every state, once."""
    if summary["particles_lost"] != 0:
        return f"{summary['particles_lost']} of {summary['particles']} particles were lost"
    for state in states:
        ids = state.data["Id"]
        if len(ids) != summary["particles"] or len(numpy.unique(ids)) != len(ids):
            return (
                f"{state.path} holds {len(numpy.unique(ids))} different particles, "
                f"the run began with {summary['particles']}"
            )
    return None


def numbers_finite(summary, states):
    """No coordinate or velocity is infinite or not a number."""
    for state in states:
        for name, values in {"Points": state.points, **state.data}.items():
            if not numpy.isfinite(values).all():
                return f"{name} in {state.path} holds values that are not finite"
    return None


def particles_above_base(summary, states):
    """No particle is through the base plane."""
    for state in states:
        if len(state.points) and state.points[:, 2].min() <= 0:
            return f"the centre of a particle in {state.path} is below the base plane"
    return None


def stages_settled(summary, stages):
    """Every stage that was asked for ran, came to rest, and the run ended."""
    if summary["status"] != "finished":
        return f"the run is {summary['status']}, not finished; continue it with recoat-solve resume"
    run = {stage["name"]: stage for stage in summary["stages"]}
    for name in stages:
        if name not in run:
            return f"the run has no stage {name}"
        if not run[name]["settled"]:
            return f"stage {name} ended before the particles came to rest; give it a longer settling time"
    return None


def energy_balance_error(summary):
    """Error of the energy balance as a share of the blade's work, or of the dissipated energy where no blade moves."""
    energy = summary["energy"]
    dissipated = sum(abs(energy[name]) for name in energy if name.startswith("dissipated"))
    blade_moves = any(stage["name"] == "spread" for stage in summary["stages"])
    scale = abs(energy["wall_work"]) if blade_moves else dissipated
    if scale == 0:
        return 0.0 if energy["balance_error"] == 0 else math.inf
    return abs(energy["balance_error"]) / scale


def energy_balanced(summary, bound):
    """The energy balance closes."""
    error = energy_balance_error(summary)
    if not error <= bound:
        work = "blade's work" if any(stage["name"] == "spread" for stage in summary["stages"]) else "dissipated energy"
        return (
            f"the energy balance is off by {100 * error:.3g} % of the {work} (bound {100 * bound:g} %); "
            "give this stiffness ratio a shorter time step"
        )
    return None


def overlaps_small(summary, bound):
    """Overlaps stay small against the particles."""
    for stage in summary["stages"]:
        if not stage["largest_overlap"] <= bound:
            return (
                f"the largest overlap in stage {stage['name']} is {stage['largest_overlap']:.3g} of a particle "
                f"diameter (bound {bound:g}); give a shorter time step or a larger stiffness ratio"
            )
    return None


def metrics_plausible(metrics):
    """Shares sum to one, packing densities are possible."""
    for path, values in metrics.items():
        clusters = values["clusters"]
        if clusters["n_particles"] == 0:
            return f"{path}: no particle lies in the analysed region"
        if abs(sum(clusters["cn_fraction"]) - 1) > 1e-6 or abs(sum(clusters["size_fraction"].values()) - 1) > 1e-6:
            return f"{path}: shares of the coordination number or the cluster size do not sum to one"
        if not 0 < values["totals"]["eq14_clipped"] < 0.7405:
            return (
                f"{path}: a global packing density of {values['totals']['eq14_clipped']:.3g} is impossible for spheres"
            )
    return None


def judge(summary, states, metrics, stages, bounds):
    """Every check with its outcome: None where it holds, the reason where it does not."""
    return {
        "particles conserved": particles_kept(summary, states),
        "numbers finite": numbers_finite(summary, states),
        "particles above the base": particles_above_base(summary, states),
        "stages settled": stages_settled(summary, stages),
        "energy balanced": energy_balanced(summary, bounds["energy_balance_error"]),
        "overlaps small": overlaps_small(summary, bounds["largest_overlap"]),
        "metrics plausible": metrics_plausible(metrics),
    }


def refuse(summary_path, summary, outcome):
    """Raise the first reason as one sentence that names the case and its file."""
    for reason in outcome.values():
        if reason is not None:
            raise Implausible(
                f"Bo = {summary['bond_number']:g}, stiffness ratio {summary['stiffness_ratio']:g}, "
                f"seed {summary['seed']}: {reason} ({summary_path})"
            )


if __name__ == "__main__":
    with logged(snakemake):
        paths = snakemake.input
        summary = read_json(paths.summary)
        states = [read_state(path) for path in paths.states]
        metrics = {path: read_json(path) for path in paths.metrics}
        outcome = judge(summary, states, metrics, snakemake.params.stages, snakemake.params.bounds)
        refuse(paths.summary, summary, outcome)
        write_json(
            snakemake.output[0],
            {
                "checks": list(outcome),
                "energy_balance_error": energy_balance_error(summary),
                "largest_overlap": max(stage["largest_overlap"] for stage in summary["stages"]),
                "bounds": dict(snakemake.params.bounds),
            },
        )
