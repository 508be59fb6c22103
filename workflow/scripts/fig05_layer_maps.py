"""Figure 5: particles from above, coloured by coordination number, and the map of the local packing density."""

import numpy

from from_above import centres, disks, frame, name_row, rows_of_maps, shown_length
from layers import by_bond, load_layers
from reporting import logged
from style import PACKING_MAP, bond_label, coordination_colours, coordination_ticks, save, scale_bar

SEEDS = 2  # runs of each Bond number that are shown


def shown_layers(layers):
    """The first runs of every Bond number."""
    return [layer for members in by_bond(layers).values() for layer in members[:SEEDS]]


def row_label(layer, shown):
    """Bond number, and the seed where several are shown."""
    several = sum(other.bond == layer.bond for other in shown) > 1
    return bond_label(layer.bond) + (f", seed {layer.seed}" if several else "")


def draw_particles(axes, layer, extent, colours, norm, classes):
    """Disks of the particles with their centre in the section, upper ones on top."""
    x, y = centres(layer)
    shown = numpy.flatnonzero((x >= extent[0]) & (x < extent[1]))
    shown = shown[numpy.argsort(layer.state.points[shown, 2], kind="stable")]
    diameters = 2 * layer.state.radius[shown] / layer.diameter
    style = {"cmap": colours, "norm": norm, "edgecolors": "black", "linewidths": 0.15}
    drawn = disks(axes, x[shown], y[shown], diameters, **style)
    drawn.set_array(numpy.tile(numpy.minimum(layer.coordination[shown], classes - 1), 3))
    return drawn


def draw(layers):
    shown = shown_layers(layers)
    return draw_rows(shown, [row_label(layer, shown) for layer in shown])


def draw_rows(shown, labels):
    """Particles and local packing density of each layer beside each other, one layer a row."""
    length = shown_length(shown)
    largest = max(len(layer.metrics["clusters"]["cn_counts"]) - 1 for layer in shown)
    colours, norm, classes = coordination_colours(largest)
    densest = max(layer.packing.max() for layer in shown)
    figure, panels = rows_of_maps(len(shown), 2, shown[0], length)
    for (left, right), layer, label in zip(panels, shown, labels):
        extent = frame(left, layer, length)
        drawn = draw_particles(left, layer, extent, colours, norm, classes)
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
        frame(right, layer, length)
        name_row(left, label)
    scale_bar(panels[0][1])
    bar = figure.colorbar(drawn, ax=panels[:, 0], location="bottom", ticks=range(classes), aspect=20)
    bar.ax.set_xticklabels(coordination_ticks(classes))
    bar.set_label("Coordination number [–]")
    figure.colorbar(image, ax=panels[:, 1], location="bottom", aspect=20).set_label(r"Local packing density $\phi$ [–]")
    return figure


if __name__ == "__main__":
    with logged(snakemake):
        layers = load_layers(snakemake)
        save(draw(layers), snakemake, layers, f"At most {SEEDS} seeds of each Bond number are shown.")
