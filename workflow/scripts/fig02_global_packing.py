"""Figure 2: global packing density of the packed bed against the stiffness ratio."""

import numpy

from layers import bed_density, by_bond, load_layers
from reporting import logged
from style import COLUMN, MARKERS, bond_colours, bond_label, pyplot, save

DODGE = 1.06  # apart on the logarithmic axis, so that bars of several Bond numbers do not cover each other


def draw(beds):
    groups = by_bond(beds)
    colours = bond_colours(groups)
    figure, axes = pyplot.subplots(figsize=(COLUMN, 0.75 * COLUMN))
    for number, ((bond, members), marker) in enumerate(zip(groups.items(), MARKERS)):
        ratios = sorted({bed.ratio for bed in members})
        style = {"color": colours[bond], "marker": marker}
        densities = {ratio: [bed_density(bed) for bed in members if bed.ratio == ratio] for ratio in ratios}
        means = numpy.array([numpy.mean([value for value, _, _ in densities[ratio]]) for ratio in ratios])
        places = numpy.array(ratios) * DODGE ** (number - 0.5 * (len(groups) - 1))
        if all(len(runs) == 1 for runs in densities.values()):
            bounds = numpy.array([densities[ratio][0][1:] for ratio in ratios])
            gap = numpy.maximum([means - bounds[:, 0], bounds[:, 1] - means], 0)
            axes.errorbar(places, means, gap, capsize=2, label=bond_label(bond), **style)
        else:
            axes.plot(places, means, label=bond_label(bond), **style)
            for place, ratio in zip(places, ratios):
                values = [value for value, _, _ in densities[ratio]]
                axes.plot([place] * len(values), values, ".", color=colours[bond], alpha=0.5)
    axes.set_xscale("log")
    axes.margins(y=0.3)
    axes.set_xlabel(r"Stiffness ratio $Y^{\mathrm{R}}/Y^{\mathrm{O}}$ [–]")
    axes.set_ylabel(r"Global packing density $\Phi$ [–]")
    axes.legend()
    return figure


if __name__ == "__main__":
    with logged(snakemake):
        beds = load_layers(snakemake)
        save(draw(beds), snakemake, beds)
