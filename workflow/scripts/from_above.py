"""What figures that look down on layers share: the section that is shown, its frame, and disks of true size."""

import numpy
from matplotlib.collections import EllipseCollection

SECTION = 80  # longest part of a layer that is shown [d_p]


def shown_length(layers):
    """Length of the section [d_p], the same for all layers of a figure."""
    return min(SECTION, min(layer.x_range[1] - layer.x_range[0] for layer in layers))


def frame(axes, layer, length):
    """Axes over the first `length` of the analysed part of a layer and over its width; returns (x0, x1)."""
    extent = (layer.x_range[0], layer.x_range[0] + length)
    axes.set_aspect("equal")
    axes.set_xlim(*extent)
    axes.set_ylim(0, layer.width)
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
