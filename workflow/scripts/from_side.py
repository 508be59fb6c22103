"""What figures that look along y share: spheres of true size, the nearest on top."""

import numpy
from matplotlib.collections import EllipseCollection


def spheres(axes, state, shown, **style):
    """Disks of the particles numbered in `shown`; lengths in d_p. Returns (the collection, their numbers in its order)."""
    points, diameter = state.points / state.diameter, 2 * state.radius / state.diameter
    order = shown[numpy.argsort(-points[shown, 1], kind="stable")]
    disks = EllipseCollection(
        *2 * [diameter[order]],
        numpy.zeros(len(order)),
        units="xy",
        offsets=points[order][:, [0, 2]],
        offset_transform=axes.transData,
        edgecolors="black",
        **style,
    )
    axes.add_collection(disks)
    return disks, order
