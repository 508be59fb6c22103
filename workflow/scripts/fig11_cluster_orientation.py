"""Figure 11: orientation of clusters, in groups of cluster size."""

import numpy
from matplotlib.patches import Patch

from layers import by_bond, load_layers
from reporting import logged
from style import PAGE, bond_colours, bond_label, bond_panels, pyplot, save

GROUPS = {"2": 1.0, "3-4": 0.6, ">=5": 0.25}  # size of the cluster: strength of the colour


def tint(colour, strength):
    """The colour mixed with white."""
    return tuple(1 - strength * (1 - part) for part in colour[:3])


def draw_panel(axes, groups, bonds, colours):
    """Bars of the Bond numbers side by side in each bin of the angle, stacked by cluster size."""
    edges = numpy.array(groups[bonds[0]][0].metrics["clusters"]["orientation_bin_edges"])
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
    axes.set_xticks(edges)
    axes.set_xlabel("Angle to the spreading direction [°]")


def draw(layers):
    groups = by_bond(layers)
    colours = bond_colours(groups)
    panels = bond_panels(groups)
    figure, rows = pyplot.subplots(len(panels), 1, figsize=(PAGE, 0.36 * PAGE * len(panels)), squeeze=False)
    for axes, (title, bonds) in zip(rows[:, 0], panels):
        draw_panel(axes, groups, bonds, colours)
        axes.set_title(title)
        axes.set_ylabel("Share of particles [%]")
        axes.margins(x=0.01)
        axes.set_ylim(top=1.05 * axes.dataLim.y1)
        hues = [
            Patch(facecolor=colours[bond], edgecolor="black", linewidth=0.3, label=bond_label(bond)) for bond in bonds
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
        axes.legend(handles=hues + tints, loc="center left", bbox_to_anchor=(1.0, 0.5))
    return figure


if __name__ == "__main__":
    with logged(snakemake):
        layers = load_layers(snakemake)
        save(draw(layers), snakemake, layers)
