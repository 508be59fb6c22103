"""Where the energy went while a layer was spread: normal damping (collisions), sliding, rolling.

energy.csv holds sums since the start of the run, row by row; the summary holds them at its end. Losses of the stage are
what was added since it began. They are those of all particles, the heap before the blade among them.
"""

import numpy
import pandas

from reporting import Implausible, logged, read_json, write_text

WAYS = {"collisions": "normal", "sliding": "tangential", "rolling": "rolling"}


def first_step(summary, stage):
    """Step at which a stage began."""
    steps = 0
    for done in summary["stages"]:
        if done["name"] == stage:
            return steps
        steps += done["steps"]
    raise Implausible(f"the run has no stage {stage}")


def losses(energy, summary, stage="spread"):
    """Energy lost in the last stage of a run [J] by way; energy: the table of energy.csv."""
    begin = first_step(summary, stage)
    found = {}
    for way, name in WAYS.items():
        before = numpy.interp(begin, energy["step"], energy[f"dissipated_{name}_J"])
        found[way] = summary["energy"][f"dissipated_{name}"] - before
    return found


def shares(energy, summary):
    """loss_WAY: shares of the energy lost while spreading."""
    found = losses(energy, summary)
    total = sum(found.values())
    return {f"loss_{way}": lost / total if total > 0 else numpy.nan for way, lost in found.items()}


def table(cases, energies, summaries):
    """One row per layer: losses while spreading [J] and as shares, and the work of the blade [J]."""
    rows = []
    for case, energy, summary in zip(cases, energies, summaries, strict=True):
        row = {"bond_number": case["bond"], "stiffness_ratio": case["ratio"], "seed": case["seed"]}
        row |= {f"{way}_J": lost for way, lost in losses(energy, summary).items()} | shares(energy, summary)
        rows.append(row | {"blade_work_J": summary["energy"]["wall_work"]})
    return pandas.DataFrame(rows)


if __name__ == "__main__":
    with logged(snakemake):
        energies = [pandas.read_csv(path) for path in snakemake.input.energies]
        summaries = [read_json(path) for path in snakemake.input.summaries]
        found = table(snakemake.params.cases, energies, summaries)
        write_text(snakemake.output[0], found.to_csv(index=False, float_format="%.6g"))
