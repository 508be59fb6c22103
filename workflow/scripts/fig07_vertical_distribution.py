"""Figure 7: share of particle centres by height."""

import numpy

from layers import by_bond, load_layers
from reporting import logged
from replicates import over_replicates
from style import MARKERS, WIDTH, bond_colours, bond_label, error_bars, legend_above, particles_of, pyplot, save

BIN = 0.1  # d_p
DODGE = 0.07  # d_p over which the Bond numbers are set apart within a bin


def bin_numbers(layer):
    """Number of the bin, centred on a multiple of 0.1 d_p, that the centre of each particle of the file is in."""
    return numpy.floor(layer.state.points[:, 2] / layer.diameter / BIN + 0.5 + 1e-6).astype(int)


def vertical_shares(groups, bins):
    """Shares of the bins with their intervals; see over_replicates."""
    return over_replicates(groups, lambda layer: layer.share_interval(numpy.minimum(bin_numbers(layer), bins), bins))


def runs(found):
    """Stretches of neighbouring bins that hold particles."""
    return numpy.split(found, numpy.flatnonzero(numpy.diff(found) > 1) + 1)


def draw(layers):
    groups = by_bond(layers)
    colours = bond_colours(groups)
    bins = max(len(layer.metrics["vertical"]["fraction"]) for layer in layers)
    figure, axes = pyplot.subplots(figsize=(WIDTH, 0.95 * WIDTH))
    found_shares = vertical_shares(groups, bins)
    shifts = DODGE * (numpy.arange(len(groups)) / max(len(groups) - 1, 1) - 0.5)
    for (bond, members), marker, shift in zip(groups.items(), MARKERS, shifts):
        shares, lower, upper = (100 * part for part in found_shares[bond])
        found = numpy.flatnonzero(shares > 0)
        places = BIN * numpy.arange(bins) + shift
        style = {"color": colours[bond], "markersize": 3.5, "markeredgecolor": "black", "markeredgewidth": 0.3}
        axes.plot([], [], marker, label=bond_label(bond, particles_of(members)), **style)
        for stretch in runs(found):
            axes.plot(places[stretch], shares[stretch], marker=marker, linewidth=0.7, zorder=5, **style)
        error_bars(axes, places[found], shares[found], numpy.maximum(lower[found], 1e-3), upper[found], capsize=0)
    axes.set_yscale("log")
    axes.set_yticks([0.1, 1, 10, 100], ["0.1", "1", "10", "100"])
    axes.set_ylim(0.05, 150)
    axes.axvline(1.0, color="grey", linewidth=0.6, linestyle=":")
    axes.set_xlim(0.4, max(1.25, BIN * bins))
    axes.set_xlabel(r"Height of the particle centre $z/d_p$ [–]")
    axes.set_ylabel("Share of particles in 0.1 $d_p$ [%]")
    legend_above(axes)
    return figure


if __name__ == "__main__":
    with logged(snakemake):
        layers = load_layers(snakemake)
        save(draw(layers), snakemake, layers)
