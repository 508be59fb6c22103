"""Figure 15: cumulative size distribution of (a) density pores, (b) chamber pores."""

from itertools import cycle

import numpy

from layers import by_bond, load_layers
from reporting import logged
from replicates import over_replicates
from style import LINES, bond_colours, bond_label, legend_above, panels_below_each_other, save

FEWEST_FOR_CURVE = 5  # pores; a step of a quarter is no distribution
PLACES = 121  # at which the bands are found
FEWEST_FOR_BAND = 20  # pores; the band of fewer would cover the whole panel


def density_sizes(layer):
    """x and diameter of the density pores [d_p]."""
    return numpy.array([(pore["x"], pore["diameter"]) for pore in layer.density_pores]).reshape(-1, 2).T


def chamber_sizes(layer):
    """x and diameter of the chambers [d_p]."""
    return layer.chambers[:, [0, 2]].T


def cumulative(sizes, at):
    """Share of the sizes up to each of the given ones; not a number without sizes."""
    if len(sizes) == 0:
        return numpy.full(len(at), numpy.nan)
    return numpy.searchsorted(numpy.sort(sizes), at, side="right") / len(sizes)


def bands(groups, sizes_of):
    """Sizes and the interval of the share up to each; of the Bond numbers that have enough pores."""
    sizes = {bond: numpy.concatenate([sizes_of(layer)[1] for layer in members]) for bond, members in groups.items()}
    enough = {bond: members for bond, members in groups.items() if len(sizes[bond]) >= FEWEST_FOR_BAND}
    if not enough:
        return {}
    places = numpy.linspace(0, max(sizes[bond].max() for bond in enough), PLACES)

    def share(layer):
        x, own = sizes_of(layer)
        return cumulative(own, places), *layer.pore_interval(x, own, lambda chosen: cumulative(chosen, places))

    found = over_replicates(enough, share)
    return {bond: (places, *numpy.clip([lower, upper], 0, 1)) for bond, (_, lower, upper) in found.items()}


def draw_panel(axes, groups, colours, sizes_of, title):
    """A step curve for each Bond number over the sizes of all its seeds, and the band of its interval."""
    for (bond, members), line in zip(groups.items(), cycle(LINES)):
        sizes = numpy.sort(numpy.concatenate([sizes_of(layer)[1] for layer in members]))
        label = bond_label(bond, len(sizes))
        style = {"color": colours[bond], "linestyle": line, "zorder": 3}
        if len(sizes) < FEWEST_FOR_CURVE:
            axes.plot([], [], " ", label=f"{label}: no curve")
            axes.plot(sizes, numpy.full(len(sizes), 2.0), "|", color=colours[bond], markersize=7)
            continue
        steps = numpy.append(0, numpy.unique(sizes))
        axes.step(steps, 100 * cumulative(sizes, steps), where="post", label=label, **style)
    for bond, (places, lower, upper) in bands(groups, sizes_of).items():
        axes.fill_between(places, 100 * lower, 100 * upper, color=colours[bond], alpha=0.12, linewidth=0)
    axes.set_xlim(left=0)
    axes.set_ylim(0, 102)
    axes.set_ylabel("Cumulative share [%]")
    legend_above(axes, title, columns=2)


def draw(layers):
    groups = by_bond(layers)
    colours = bond_colours(groups)
    figure, (above, below) = panels_below_each_other(2, 0.75)
    draw_panel(above, groups, colours, density_sizes, "(a) density pores")
    draw_panel(below, groups, colours, chamber_sizes, "(b) chamber pores")
    above.set_xlabel(r"Equivalent diameter of density pore $D/d_p$ [–]")
    below.set_xlabel(r"Diameter of chamber pore $D/d_p$ [–]")
    return figure


if __name__ == "__main__":
    with logged(snakemake):
        layers = load_layers(snakemake)
        save(draw(layers), snakemake, layers)
