"""Figure 8: local packing density against the Bond number: (a) box plots, (b) interquartile range over median."""

import numpy
from matplotlib.cbook import boxplot_stats

from layers import by_bond, load_layers
from reporting import logged
from style import PAGE, bond_colours, bond_series, pyplot, save


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
    axes.set_xlabel("Bond number Bo [–]")
    axes.set_ylabel(r"Local packing density $\phi$ [–]")
    axes.set_title("(a)")


def spread_of(layer):
    """IQR over median with its 95 % interval."""
    return layer.estimate("phi_exact", "iqr_over_median")


def draw(layers):
    groups = by_bond(layers)
    figure, (left, right) = pyplot.subplots(1, 2, figsize=(PAGE, 0.4 * PAGE))
    draw_boxes(left, groups, bond_colours(groups))
    bond_series(right, groups, spread_of)
    # An interval whose median comes close to nothing is cut off, or it would hide all the others.
    values = [spread_of(layer)[0] for layer in layers]
    right.set_ylim(0, 1.5 * numpy.nanmax([*values, 0.1]))
    right.set_ylabel(r"IQR / median of $\phi$ [–]")
    right.set_title("(b)")
    return figure


if __name__ == "__main__":
    with logged(snakemake):
        layers = load_layers(snakemake)
        save(draw(layers), snakemake, layers)
