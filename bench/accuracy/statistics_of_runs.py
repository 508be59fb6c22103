"""Means and scatter of replicate runs, and how far a setting is from another."""

import numpy
from scipy.stats import t as student

PLACE = " The state of the moment before"  # begins where a fault says where its state is, which is not kept
LEAST_PAIRS = 3


def summarise(runs):
    """One entry for runs that differ in the seed only.

    `quantities` and `costs` are as `spread` gives them, of the runs without a fault.
    """
    good = [run for run in runs if run["exit_code"] == 0]
    summary = {
        "runs": len(runs),
        "faults": len(runs) - len(good),
        "sentences": sorted({run["sentence"].split(PLACE)[0] for run in runs if run["exit_code"] != 0}),
    }
    if not good:
        return summary
    seconds = {run["seed"]: run["processor_seconds"] for run in good}
    particle_steps = {run["seed"]: run["steps"] * run["particles"] for run in good}
    return summary | {
        "processor_seconds": float(numpy.mean(list(seconds.values()))),
        "seconds_per_particle_step": sum(seconds.values()) / sum(particle_steps.values()),
        "simulated_seconds": float(numpy.mean([run["simulated_seconds"] for run in good])),
        "energy_balance_error": max(abs(run["energy_balance_error"]) for run in good),
        "largest_overlap": max(run["largest_overlap"] for run in good),
        "costs": {
            "processor_seconds": spread(seconds),
            "seconds_per_particle_step": spread({seed: seconds[seed] / particle_steps[seed] for seed in seconds}),
        },
        "quantities": {
            name: spread({run["seed"]: run["quantities"][name] for run in good}) for name in good[0]["quantities"]
        },
    }


def spread(values):
    """Mean, scatter and standard error of a number over replicates, which are given by their seeds.

    `scatter` is the standard deviation between replicates, `standard_error` that of their mean; null for one run.
    `by_seed` has those that are known.
    """
    by_seed = {str(seed): value for seed, value in values.items() if value is not None}
    known = list(by_seed.values())
    if not known:
        return {"mean": None, "scatter": None, "standard_error": None, "known": 0, "by_seed": {}}
    scatter = float(numpy.std(known, ddof=1)) if len(known) > 1 else None
    return {
        "mean": float(numpy.mean(known)),
        "scatter": scatter,
        "standard_error": scatter / len(known) ** 0.5 if scatter is not None else None,
        "known": len(known),
        "by_seed": by_seed,
    }


def pooled(entries, name):
    """Mean and scatter of a quantity over the replicates of several settings, which are taken to be alike.

    None if no setting has two replicates.
    """
    parts = [entry["quantities"][name] for entry in entries if "quantities" in entry]
    parts = [part for part in parts if part["scatter"] is not None]
    if not parts:
        return None
    counts = numpy.array([part["known"] for part in parts])
    means = numpy.array([part["mean"] for part in parts])
    within = sum((part["known"] - 1) * part["scatter"] ** 2 for part in parts)
    freedom = int(counts.sum()) - len(parts)
    return {"mean": float((counts * means).sum() / counts.sum()), "scatter": float((within / freedom) ** 0.5)}


def mean_by_seed(parts):
    """For each seed the mean over those of several settings that have it."""
    seeds = sorted({seed for part in parts for seed in part["by_seed"]}, key=int)
    return {seed: float(numpy.mean([p["by_seed"][seed] for p in parts if seed in p["by_seed"]])) for seed in seeds}


def student_difference(own, other, allowed=0.0):
    """Mean of own less other, its standard error, and how likely chance alone is to make it as large: `chance` if
    there were none (two-sided, Student), `chance_beyond` if it were the one that is allowed (one-sided). `pairs` is
    the number of runs of the same seed that were compared, 0 if all of both were.

    Runs of the same seed begin with the same placement: what that does to both is no part of their difference. Fewer
    than LEAST_PAIRS say little of what is left; then the means of all runs are compared, with a scatter common to both.
    Error and chances are None if there is nothing to tell a scatter from, all is None without a run.
    """
    seeds = [seed for seed in own if seed in other]
    if len(seeds) >= LEAST_PAIRS:
        differences = numpy.array([own[seed] - other[seed] for seed in seeds])
        mean, freedom = float(differences.mean()), len(seeds) - 1
        error = float(differences.std(ddof=1) / len(seeds) ** 0.5)
    elif own and other:
        seeds, groups = [], [numpy.array(list(values.values())) for values in (own, other)]
        mean, freedom = float(groups[0].mean() - groups[1].mean()), len(own) + len(other) - 2
        squares = sum(((group - group.mean()) ** 2).sum() for group in groups)
        error = float((squares / freedom * (1 / len(own) + 1 / len(other))) ** 0.5) if freedom else None
    else:
        return None
    found = {"mean": mean, "standard_error": error, "chance": None, "chance_beyond": None, "pairs": len(seeds)}
    if error is not None:
        found["chance"] = 2 * chance_of(abs(mean), error, freedom)
        found["chance_beyond"] = chance_of(abs(mean) - allowed, error, freedom)
    return found


def chance_of(excess, error, freedom):
    """How likely a mean is to come out that much larger than it is (Student)."""
    if error == 0:
        return float((1 - numpy.sign(excess)) / 2)
    return float(student.sf(excess / error, freedom))


def relative_difference(own, other):
    """By how much the mean of own is above that of other, over the seeds that both have, and its standard error.

    Both means are uncertain, and together where they share what a seed does: by the residuals of own = ratio other.
    """
    seeds = [seed for seed in own if seed in other]
    if not seeds:
        return None
    mine, theirs = (numpy.array([values[seed] for seed in seeds]) for values in (own, other))
    ratio = mine.mean() / theirs.mean()
    error = None
    if len(seeds) > 1:
        error = float((mine - ratio * theirs).std(ddof=1) / len(seeds) ** 0.5 / abs(theirs.mean()))
    return {"mean": float(ratio - 1), "standard_error": error, "pairs": len(seeds)}
