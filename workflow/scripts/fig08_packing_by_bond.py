"""Figure 8: local packing density against the Bond number: (a) box plots, (b) interquartile range over median."""

import numpy
from matplotlib.cbook import boxplot_stats

from layers import by_bond, load_layers
from reporting import logged
from replicates import over_replicates
from style import bond_colours, bond_series, panels_below_each_other, save

CUT = 1.6  # an interval may reach so much above the largest value; what is longer is cut off, with an arrow


def draw_boxes(axes, groups, colours):
    """Panel (a): the nodes of all seeds of a Bond number in one box."""
    boxes = []
    for bond, members in groups.items():
        boxes += boxplot_stats(numpy.concatenate([layer.packing.ravel() for layer in members]), labels=[f"{bond:g}"])
    drawn = axes.bxp(boxes, patch_artist=True, widths=0.55, flierprops={"marker": ".", "markersize": 2})
    for box, bond in zip(drawn["boxes"], groups):
        box.set_facecolor((*colours[bond][:3], 0.5))
    for line in drawn["medians"]:
        line.set_color("black")
    axes.set_ylabel(r"Local packing density $\phi$ [–]")
    axes.set_title("(a)", loc="left")


def spread_of(layer):
    """IQR over median with its 95 % interval."""
    return layer.estimate("phi_exact", "iqr_over_median")


def draw_spread(axes, groups):
    """Panel (b), at the places of panel (a); what cannot be drawn is said there."""
    places = range(1, len(groups) + 1)
    spreads = over_replicates(groups, spread_of)
    bond_series(axes, groups, spreads, spread_of, places)
    top = CUT * numpy.nanmax([*(value for value, _, _ in spreads.values()), 0.1])
    axes.set_ylim(0, top)
    for place, (value, _, upper) in zip(places, spreads.values()):
        if not numpy.isfinite(value):
            axes.text(place, 0.02 * top, "median 0:\nno ratio", ha="center", va="bottom", rotation=90, fontsize=6.5)
        elif upper > top:
            axes.annotate("", (place, top), (place, 0.92 * top), arrowprops={"arrowstyle": "-|>", "color": "black"})
            axes.text(place, top, f"to {upper:.2g}", ha="center", va="bottom", fontsize=6.5)
    axes.set_xticks(places, [f"{bond:g}" for bond in groups])
    axes.set_xlim(0.5, len(groups) + 0.5)
    axes.set_xlabel("Bond number Bo [–]")
    axes.set_ylabel(r"IQR / median of $\phi$ [–]")
    axes.set_title("(b)", loc="left", pad=9)


def draw(layers):
    groups = by_bond(layers)
    figure, (above, below) = panels_below_each_other(2, 0.6)
    draw_boxes(above, groups, bond_colours(groups))
    draw_spread(below, groups)
    return figure


if __name__ == "__main__":
    with logged(snakemake):
        layers = load_layers(snakemake)
        save(draw(layers), snakemake, layers)
