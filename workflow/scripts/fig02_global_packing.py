"""Figure 2: global packing density of the packed bed against the stiffness ratio."""

import numpy

from layers import bed_density, by_bond, by_case, load_layers
from reporting import logged
from replicates import over_replicates
from style import MARKERS, WIDTH, bond_colours, bond_label, error_bars, pyplot, save

DODGE = 1.06  # apart on the logarithmic axis, so that bars of several Bond numbers do not cover each other
PAPER_BOUND = 0.2  # % of the value at the largest ratio within which the paper finds all others [figure 2]


def densities(beds):
    """Bond number -> (ratios, values, lower, upper, values of the single runs as (ratio, value))."""
    found, cases = over_replicates(by_case(beds), bed_density), {}
    for bond, members in by_bond(beds).items():
        ratios = sorted({bed.ratio for bed in members})
        values = numpy.array([found[bond, ratio] for ratio in ratios], dtype=float).T
        runs = [(bed.ratio, bed_density(bed)[0]) for bed in members] if len(members) > len(ratios) else []
        cases[bond] = (ratios, *values, runs)
    return cases


def draw(beds):
    cases = densities(beds)
    colours = bond_colours(cases)
    figure, (whole, change) = pyplot.subplots(2, 1, figsize=(WIDTH, 1.15 * WIDTH), sharex=True)
    for number, ((bond, (ratios, values, lower, upper, runs)), marker) in enumerate(zip(cases.items(), MARKERS)):
        dodge = DODGE ** (number - 0.5 * (len(cases) - 1))
        places = numpy.array(ratios) * dodge
        style = {"color": colours[bond], "markeredgecolor": "black", "markeredgewidth": 0.3, "zorder": 5}
        for axes, scale, base in ((whole, 1, 0), (change, 100 / values[-1], values[-1])):
            bounds = [scale * (part - base) for part in (values, lower, upper)]
            error_bars(axes, places, *bounds)
            axes.plot(places, bounds[0], marker, label=bond_label(bond), **style)
            for ratio, value in runs:
                axes.plot([ratio * dodge], [scale * (value - base)], "_", color="black", markersize=6, zorder=4)
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
