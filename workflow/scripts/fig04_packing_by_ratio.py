"""Figure 4: box plots of the local packing density at each stiffness ratio."""

import numpy
from matplotlib.cbook import boxplot_stats

from layers import by_bond, load_layers
from reporting import logged
from style import WIDTH, bond_colours, bond_label, pyplot, save


def draw(layers):
    groups = by_bond(layers)
    colours = bond_colours(groups)
    figure, panels = pyplot.subplots(1, len(groups), figsize=(WIDTH, 0.7 * WIDTH), sharey=True, squeeze=False)
    for axes, letter, (bond, members) in zip(panels[0], "abcdefgh", groups.items()):
        ratios = sorted({layer.ratio for layer in members})
        boxes = []
        for ratio in ratios:
            values = numpy.concatenate([layer.packing.ravel() for layer in members if layer.ratio == ratio])
            boxes += boxplot_stats(values, labels=[f"{ratio:g}"])
        drawn = axes.bxp(boxes, patch_artist=True, widths=0.5, flierprops={"marker": ".", "markersize": 2})
        for box in drawn["boxes"]:
            box.set_facecolor((*colours[bond][:3], 0.5))
        for line in drawn["medians"]:
            line.set_color("black")
        axes.set_title(f"({letter}) {bond_label(bond)}")
    figure.supxlabel(r"Stiffness ratio $Y^{\mathrm{R}}/Y^{\mathrm{O}}$ [–]", fontsize=8)
    panels[0][0].set_ylabel(r"Local packing density $\phi$ [–]")
    return figure


if __name__ == "__main__":
    with logged(snakemake):
        layers = load_layers(snakemake)
        save(draw(layers), snakemake, layers)
