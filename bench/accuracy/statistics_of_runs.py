"""Means and scatter of replicate runs, and how far a setting is from a reference."""

import numpy

PLACE = " The state of the moment before"  # begins where a fault says where its state is, which is not kept


def summarise(runs):
    """One entry for runs that differ in the seed only.

    `scatter` is the standard deviation between replicates, `standard_error` that of their mean; null for one run.
    """
    good = [run for run in runs if run["exit_code"] == 0]
    summary = {
        "runs": len(runs),
        "faults": len(runs) - len(good),
        "sentences": sorted({run["sentence"].split(PLACE)[0] for run in runs if run["exit_code"] != 0}),
    }
    if not good:
        return summary
    return summary | {
        "processor_seconds": mean(good, "processor_seconds"),
        "seconds_per_particle_step": sum(run["processor_seconds"] for run in good)
        / sum(run["steps"] * run["particles"] for run in good),
        "simulated_seconds": mean(good, "simulated_seconds"),
        "energy_balance_error": max(abs(run["energy_balance_error"]) for run in good),
        "largest_overlap": max(run["largest_overlap"] for run in good),
        "quantities": {name: spread(good, name) for name in good[0]["quantities"]},
    }


def mean(runs, key):
    """Arithmetic mean of a number of the runs."""
    return float(numpy.mean([run[key] for run in runs]))


def spread(runs, name):
    """Mean, scatter and standard error of a quantity over replicates."""
    values = [run["quantities"][name] for run in runs]
    known = [value for value in values if value is not None]
    if not known:
        return {"mean": None, "scatter": None, "standard_error": None, "known": 0}
    scatter = float(numpy.std(known, ddof=1)) if len(known) > 1 else None
    return {
        "mean": float(numpy.mean(known)),
        "scatter": scatter,
        "standard_error": scatter / len(known) ** 0.5 if scatter is not None else None,
        "known": len(known),
    }


def pooled(entries, name):
    """Mean and scatter of a quantity over the replicates of several settings, which are taken to be alike."""
    parts = [entry["quantities"][name] for entry in entries if "quantities" in entry]
    parts = [part for part in parts if part["scatter"] is not None]
    if not parts:
        return None
    counts = numpy.array([part["known"] for part in parts])
    means = numpy.array([part["mean"] for part in parts])
    centre = float((counts * means).sum() / counts.sum())
    within = sum((part["known"] - 1) * part["scatter"] ** 2 for part in parts)
    freedom = int(counts.sum()) - len(parts)
    scatter = float((within / freedom) ** 0.5)
    return {"mean": centre, "scatter": scatter, "standard_error": scatter / float(counts.sum()) ** 0.5}
