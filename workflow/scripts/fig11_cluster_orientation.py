"""Figure 11: orientation of clusters, in groups of cluster size."""

import numpy
from matplotlib.patches import Patch

from layers import by_bond, load_layers
from reporting import logged
from replicates import over_replicates
from style import bond_colours, bond_label, bond_panels, error_bars, few, legend_above, panels_below_each_other, particles_of, save

GROUPS = {"2": 1.0, "3-4": 0.6, ">=5": 0.25}  # size of the cluster: strength of the colour


def angle_shares(groups, edges):
    """Shares of all particles of the region by the angle of their cluster, with intervals; the rest has no angle."""
    bins = len(edges) - 1

    def shares(layer):
        angle = numpy.nan_to_num(layer.cluster_angle, nan=edges[-1] + 1)
        number = numpy.minimum(numpy.searchsorted(edges[1:-1], angle + 1e-9, side="left"), bins - 1)
        # particles on their own and clusters without a direction make up the last group, which is not drawn
        with_angle = numpy.isfinite(layer.cluster_angle) & (layer.cluster_size > 1)
        parts = layer.share_interval(numpy.where(with_angle, number, bins), bins + 1)
        return [part[:bins] for part in parts]

    return over_replicates(groups, shares)


def tint(colour, strength):
    """The colour mixed with white."""
    return tuple(1 - strength * (1 - part) for part in colour[:3])


def add_scatter(axes, members, shares, middles, tops):
    """Intervals of the whole bars, and the numbers of particles of small ones."""
    _, lower, upper = (100 * part for part in shares)
    error_bars(axes, middles, tops, numpy.clip(lower, 0, tops), numpy.maximum(upper, tops), capsize=0.8)
    few(axes, middles, numpy.fmax(tops, upper), tops / 100 * particles_of(members))


def draw_panel(axes, groups, bonds, colours):
    """Bars of the Bond numbers side by side in each bin of the angle, stacked by cluster size."""
    edges = numpy.array(groups[bonds[0]][0].metrics["clusters"]["orientation_bin_edges"])
    shares_of = angle_shares(groups, edges)
    width = 0.86 * (edges[1] - edges[0]) / len(bonds)
    for number, bond in enumerate(bonds):
        left = edges[:-1] + 0.07 * (edges[1] - edges[0]) + number * width
        bottom = numpy.zeros(len(left))
        for size, strength in GROUPS.items():
            shares = [layer.metrics["clusters"]["orientation"][size]["fraction_of_all"] for layer in groups[bond]]
            heights = 100 * numpy.mean(shares, axis=0)
            axes.bar(
                left,
                heights,
                width,
                bottom,
                align="edge",
                color=tint(colours[bond], strength),
                edgecolor="black",
                linewidth=0.25,
            )
            bottom += heights
        add_scatter(axes, groups[bond], shares_of[bond], left + 0.5 * width, bottom)
    axes.set_xticks(edges)


def draw(layers):
    groups = by_bond(layers)
    colours = bond_colours(groups)
    panels = bond_panels(groups)
    figure, rows = panels_below_each_other(len(panels), 0.68)
    for axes, (title, bonds) in zip(rows, panels):
        draw_panel(axes, groups, bonds, colours)
        axes.set_ylabel("Share of particles [%]")
        axes.margins(x=0.01)
        axes.set_ylim(top=1.1 * axes.dataLim.y1)
        hues = [
            Patch(facecolor=colours[bond], edgecolor="black", linewidth=0.3, label=bond_label(bond, particles_of(groups[bond])))
            for bond in bonds
        ]
        tints = [
            Patch(
                facecolor=tint((0, 0, 0), strength),
                edgecolor="black",
                linewidth=0.3,
                label=f"size {size.replace('>=', '≥ ')}",
            )
            for size, strength in GROUPS.items()
        ]
        legend_above(axes, title, handles=hues + (tints if axes is rows[0] else []))
    rows[-1].set_xlabel("Angle to the spreading direction [°]")
    return figure


if __name__ == "__main__":
    with logged(snakemake):
        layers = load_layers(snakemake)
        save(draw(layers), snakemake, layers)
