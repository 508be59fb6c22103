"""Figure 2: global packing density of the packed bed against the stiffness ratio."""

import numpy

from layers import bed_density, by_bond, load_layers
from reporting import logged
from style import COLUMN, MARKERS, bond_colours, bond_label, error_bars, mean_and_range, pyplot, save

DODGE = 1.06  # apart on the logarithmic axis, so that bars of several Bond numbers do not cover each other


PAPER_BOUND = 0.2  # % of the value at the largest ratio within which the paper finds all others [figure 2]


def densities_of(members, ratios):
    """Value, lower, upper at each ratio: with bootstrap interval (one run) or range (several)."""
    found = [mean_and_range([bed_density(bed) for bed in members if bed.ratio == ratio]) for ratio in ratios]
    return numpy.array(found, dtype=float).T


def draw(beds):
    groups = by_bond(beds)
    colours = bond_colours(groups)
    figure, (whole, change) = pyplot.subplots(2, 1, figsize=(COLUMN, 1.15 * COLUMN), sharex=True)
    for number, ((bond, members), marker) in enumerate(zip(groups.items(), MARKERS)):
        ratios = sorted({bed.ratio for bed in members})
        places = numpy.array(ratios) * DODGE ** (number - 0.5 * (len(groups) - 1))
        values, lower, upper = densities_of(members, ratios)
        style = {"color": colours[bond], "markeredgecolor": "black", "markeredgewidth": 0.3, "zorder": 5}
        for axes, scale, base in ((whole, 1, 0), (change, 100 / values[-1], values[-1])):
            bounds = [scale * (part - base) for part in (values, lower, upper)]
            error_bars(axes, places, *bounds)
            axes.plot(places, bounds[0], marker, label=bond_label(bond), **style)
    change.axhspan(-PAPER_BOUND, PAPER_BOUND, color="0.85", label="the paper: all within")
    change.axhline(0, color="0.4", linewidth=0.6)
    whole.set_xscale("log")
    whole.set_ylim(0, 0.74)
    whole.set_ylabel(r"Global packing density $\Phi$ [–]")
    change.set_ylabel("Change from the\nlargest ratio [%]")
    change.set_xlabel(r"Stiffness ratio $Y^{\mathrm{R}}/Y^{\mathrm{O}}$ [–]")
    change.margins(y=0.15)
    whole.legend(ncols=2, loc="lower center")
    change.legend(handles=change.patches[:1], loc="best")
    return figure


if __name__ == "__main__":
    with logged(snakemake):
        beds = load_layers(snakemake)
        save(draw(beds), snakemake, beds)
