"""What figures that look down on layers share: the section that is shown, its frame, and disks of true size."""

import numpy
from matplotlib.collections import EllipseCollection

from style import WIDTH, pyplot

SECTION = 80  # longest part of a layer that is shown [d_p]


def shown_length(layers):
    """Length of the section [d_p], the same for all layers of a figure."""
    return min(SECTION, min(layer.x_range[1] - layer.x_range[0] for layer in layers))


def rows_of_maps(count, columns, layer, length, above=0.0, below=0.65):
    """Figure and axes [row, column] of maps as long and as wide as those of `layer`; heights [inches] of what is not a map.

    Each map has room for a line of text above it.
    """
    share = 0.94 - 0.06 * columns
    row = share * WIDTH / columns * layer.width / length + 0.19
    size = (WIDTH, count * row + 0.3 + above + below)
    figure, panels = pyplot.subplots(count, columns, figsize=size, sharex="col", sharey=True, squeeze=False)
    figure.get_layout_engine().set(h_pad=0.03, hspace=0.0, w_pad=0.02, wspace=0.02)
    for axes in panels[:, 0]:
        axes.set_ylabel("$y/d_p$", labelpad=1)
    for axes in panels[-1]:
        axes.set_xlabel("$x/d_p$", labelpad=1)
    return figure, panels


def name_row(axes, text):
    """What a map shows, above it; runs on over the maps beside it."""
    axes.set_title(text, loc="left", fontsize=7, pad=2)


def frame(axes, layer, length):
    """Axes over the first `length` of the analysed part of a layer and over its width; returns (x0, x1)."""
    extent = (layer.x_range[0], layer.x_range[0] + length)
    axes.set_aspect("equal")
    axes.set_xlim(*extent)
    axes.set_ylim(0, layer.width)
    axes.set_yticks([0, layer.width])
    axes.spines[["top", "right"]].set_visible(True)
    return extent


def centres(layer):
    """x and y of all particles [d_p], y from the edge of the period."""
    position = layer.state.points / layer.diameter
    y_min = layer.metrics["config"]["y_min"] / layer.diameter
    return position[:, 0], (position[:, 1] - y_min) % layer.width


def disks(axes, x, y, diameters, **style):
    """Circles of true size; those over the periodic boundary are drawn on both sides."""
    low, high = axes.get_ylim()
    places = numpy.vstack([numpy.column_stack([x, y + turn * (high - low)]) for turn in (-1, 0, 1)])
    collection = EllipseCollection(
        *2 * [numpy.tile(diameters, 3)],
        numpy.zeros(len(places)),
        units="xy",
        offsets=places,
        offset_transform=axes.transData,
        **style,
    )
    axes.add_collection(collection)
    return collection
