"""Figure 14: density pores coloured by their orientation, and chamber pores coloured by their size."""

import numpy
from matplotlib.colors import ListedColormap, LogNorm
from matplotlib.patches import Patch

from from_above import centres, disks, frame, name_row, rows_of_maps, shown_length
from layers import by_bond, load_layers
from reporting import logged
from style import bond_label, save, scale_bar

ORIENTATION, SIZE = "viridis", "plasma"
NO_ANGLE = "0.55"  # round the period, or without a direction that stands out
PARTICLE = "0.86"


def draw_particles(axes, layer):
    """The layer in light grey."""
    x, y = centres(layer)
    near = (x > layer.x_range[0] - 1) & (x < layer.x_range[1] + 1)
    diameters = 2 * layer.state.radius / layer.diameter
    disks(axes, x[near], y[near], diameters[near], facecolors=PARTICLE, edgecolors="none")


def draw_density_pores(axes, layer, extent):
    """Cells of the pores, coloured by the angle of their pore."""
    numbers = numpy.array(layer.metrics["maps"]["density_pore_8"])
    angles = numpy.array([numpy.nan] + [pore.get("angle") for pore in layer.density_pores], dtype=float)
    cells = (layer.x_range[0], layer.x_range[1], 0, layer.width)
    show = {"origin": "lower", "extent": cells, "interpolation": "nearest", "aspect": "equal"}
    undirected = numpy.where((numbers > 0) & numpy.isnan(angles[numbers]), 1.0, numpy.nan)
    axes.imshow(undirected.T, cmap=ListedColormap([NO_ANGLE]), **show)
    image = axes.imshow(angles[numbers].T, cmap=ORIENTATION, vmin=0, vmax=90, alpha=0.9, **show)
    axes.set_xlim(*extent)
    return image


def draw_chambers(axes, layer, norm):
    """Circles of the chambers, coloured by their diameter."""
    x, y, diameter = layer.chambers.T
    circles = disks(axes, x + layer.x_range[0], y, diameter, cmap=SIZE, norm=norm, edgecolors="black", linewidths=0.2)
    circles.set_array(numpy.tile(diameter, 3))
    return circles


def draw(layers):
    shown = [members[0] for members in by_bond(layers).values()]
    length = shown_length(shown)
    # Logarithmic: the few chambers of a nearly empty layer would leave all others one colour.
    sizes = numpy.concatenate([layer.chambers[:, 2] for layer in shown] + [[0.5, 1.0]])
    norm = LogNorm(sizes.min(), sizes.max())
    figure, panels = rows_of_maps(len(shown), 2, shown[0], length, above=0.35)
    for (left, right), layer in zip(panels, shown):
        for axes in (left, right):
            extent = frame(axes, layer, length)
            draw_particles(axes, layer)
        image = draw_density_pores(left, layer, extent)
        left.set_ylim(0, layer.width)
        circles = draw_chambers(right, layer, norm)
        name_row(left, bond_label(layer.bond))
    scale_bar(panels[0][1])
    bar = figure.colorbar(image, ax=panels[:, 0], location="bottom", aspect=20, ticks=range(0, 91, 30))
    bar.set_label("Angle of density pore [°]")
    bar = figure.colorbar(circles, ax=panels[:, 1], location="bottom", aspect=20)
    ticks = [size for size in (0.5, 1, 2, 5, 10, 20, 50) if sizes.min() <= size <= sizes.max()]
    bar.set_ticks(ticks, labels=[f"{size:g}" for size in ticks])
    bar.ax.minorticks_off()
    bar.set_label(r"Chamber pore $D/d_p$ [–]")
    greys = {"particles": PARTICLE, "density pore without direction, or round the period": NO_ANGLE}
    patches = [Patch(color=grey, label=label) for label, grey in greys.items()]
    figure.legend(handles=patches, loc="outside upper left")
    return figure


if __name__ == "__main__":
    with logged(snakemake):
        layers = load_layers(snakemake)
        save(draw(layers), snakemake, layers, "One seed of each Bond number is shown.")
