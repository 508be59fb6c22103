"""Figure 5: particles from above, coloured by coordination number, and the map of the local packing density."""

import numpy
from matplotlib.collections import EllipseCollection

from layers import by_bond, load_layers
from reporting import logged
from style import PACKING_MAP, PAGE, bond_label, coordination_colours, coordination_ticks, pyplot, save

SECTION = 80  # longest part of a layer that is shown [d_p]


def draw_particles(axes, layer, extent, colours, norm, classes):
    """Disks of the particles with their centre in the section, upper ones on top."""
    position = layer.state.points / layer.diameter
    y_min = layer.metrics["config"]["y_min"] / layer.diameter
    y = (position[:, 1] - y_min) % layer.width
    shown = (position[:, 0] >= extent[0]) & (position[:, 0] < extent[1])
    order = numpy.argsort(position[shown, 2], kind="stable")
    centres = numpy.column_stack([position[shown, 0], y[shown]])[order]
    diameters = 2 * layer.state.radius[shown][order] / layer.diameter
    disks = EllipseCollection(
        diameters,
        diameters,
        numpy.zeros(len(order)),
        units="xy",
        offsets=centres,
        offset_transform=axes.transData,
        cmap=colours,
        norm=norm,
        edgecolors="black",
        linewidths=0.15,
    )
    disks.set_array(numpy.minimum(layer.coordination[shown][order], classes - 1))
    axes.add_collection(disks)
    return disks


def draw(layers):
    shown = [members[0] for members in by_bond(layers).values()]
    length = min(SECTION, min(layer.x_range[1] - layer.x_range[0] for layer in shown))
    largest = max(len(layer.metrics["clusters"]["cn_counts"]) - 1 for layer in shown)
    colours, norm, classes = coordination_colours(largest)
    densest = max(layer.packing.max() for layer in shown)
    row = 0.42 * PAGE * shown[0].width / length + 0.14
    figure, panels = pyplot.subplots(
        len(shown), 2, figsize=(PAGE, len(shown) * row + 0.8), sharex=True, sharey=True, squeeze=False
    )
    for (left, right), layer in zip(panels, shown):
        extent = (layer.x_range[0], layer.x_range[0] + length)
        disks = draw_particles(left, layer, extent, colours, norm, classes)
        first = layer.x_range[0] + (layer.cells - len(layer.packing)) // 2 * layer.cell  # outer nodes may be left out
        image = right.imshow(
            layer.packing.T,
            origin="lower",
            extent=(first, first + len(layer.packing) * layer.cell, 0, layer.width),
            vmin=0,
            vmax=densest,
            cmap=PACKING_MAP,
            interpolation="nearest",
        )
        for axes in (left, right):
            axes.set_aspect("equal")
            axes.set_xlim(*extent)
            axes.set_ylim(0, layer.width)
            axes.spines[["top", "right"]].set_visible(True)
        left.set_ylabel(f"{bond_label(layer.bond)}\n$y/d_p$")
    for axes in panels[-1]:
        axes.set_xlabel(r"$x/d_p$ [–] (spreading direction)")
    bar = figure.colorbar(disks, ax=panels[:, 0], location="bottom", ticks=range(classes), shrink=0.8, aspect=35)
    bar.ax.set_xticklabels(coordination_ticks(classes))
    bar.set_label("Coordination number [–]")
    figure.colorbar(image, ax=panels[:, 1], location="bottom", shrink=0.8, aspect=35).set_label(
        r"Local packing density $\phi$ [–]"
    )
    return figure


if __name__ == "__main__":
    with logged(snakemake):
        layers = load_layers(snakemake)
        save(draw(layers), snakemake, layers, "One seed of each Bond number is shown.")
