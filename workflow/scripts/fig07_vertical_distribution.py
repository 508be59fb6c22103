"""Figure 7: share of particle centres by height."""

import numpy

from layers import by_bond, load_layers
from reporting import logged
from style import COLUMN, MARKERS, bond_colours, bond_label, pyplot, save


def vertical_shares(members):
    """Heights of the bins and the mean over the seeds of their shares."""
    edge = max(len(layer.metrics["vertical"]["bin_centres"]) for layer in members)
    longest = max(members, key=lambda layer: len(layer.metrics["vertical"]["bin_centres"]))
    shares = [numpy.pad(f := layer.metrics["vertical"]["fraction"], (0, edge - len(f))) for layer in members]
    return numpy.array(longest.metrics["vertical"]["bin_centres"]), numpy.mean(shares, axis=0)


def draw(layers):
    groups = by_bond(layers)
    colours = bond_colours(groups)
    figure, axes = pyplot.subplots(figsize=(COLUMN, 0.85 * COLUMN))
    for (bond, members), marker in zip(groups.items(), MARKERS):
        heights, shares = vertical_shares(members)
        found = shares > 0
        axes.plot(
            heights[found],
            100 * shares[found],
            color=colours[bond],
            marker=marker,
            markersize=3.5,
            linewidth=0.9,
            label=bond_label(bond),
        )
    axes.set_yscale("log")
    axes.set_yticks([0.1, 1, 10, 100], ["0.1", "1", "10", "100"])
    axes.set_ylim(0.05, 130)
    axes.axvline(1.0, color="grey", linewidth=0.6, linestyle=":")
    axes.set_xlim(0.3, 1.6)
    axes.set_xlabel(r"Height of the particle centre $z/d_p$ [–]")
    axes.set_ylabel("Share of particles in 0.1 $d_p$ [%]")
    axes.legend(ncols=2)
    return figure


if __name__ == "__main__":
    with logged(snakemake):
        layers = load_layers(snakemake)
        save(draw(layers), snakemake, layers)
