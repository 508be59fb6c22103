"""Figure 1: the process and the analysed part of the layer, drawn from the states of a run."""

import numpy
from matplotlib.collections import EllipseCollection
from matplotlib.patches import Rectangle

from fig05_rendered_layer import blade_bounds
from layers import Layer
from reporting import logged
from states import fill_box, read_state
from style import PAGE, pyplot, save

DEPTH = 2  # of the slice along y that is shown [d_p]
POWDER, STEEL, BASE = "#c9ad7c", "0.45", "0.8"


def side_view(axes, state):
    """Particles of a slice, the nearest on top; (x of the first, x of the last, highest z) [d_p]."""
    points, diameter = state.points / state.diameter, 2 * state.radius / state.diameter
    y = points[:, 1] - float(state.info["y_min"]) / state.diameter
    shown = numpy.flatnonzero(y < DEPTH)
    shown = shown[numpy.argsort(-y[shown], kind="stable")]
    disks = EllipseCollection(
        *2 * [diameter[shown]],
        numpy.zeros(len(shown)),
        units="xy",
        offsets=points[shown][:, [0, 2]],
        offset_transform=axes.transData,
        facecolors=POWDER,
        edgecolors="black",
        linewidths=0.15,
    )
    axes.add_collection(disks)
    return points[shown, 0].min(), points[shown, 0].max(), points[shown, 2].max()


def box(axes, left, right, bottom, top, colour=STEEL):
    """A wall seen from the side."""
    axes.add_patch(Rectangle((left, bottom), right - left, top - bottom, facecolor=colour, edgecolor="black", linewidth=0.5))


def arrow(axes, begin, end, text, style="->"):
    """An arrow, or a dimension, with its name above its middle."""
    axes.annotate("", end, begin, arrowprops={"arrowstyle": style, "linewidth": 0.7, "shrinkA": 0, "shrinkB": 0})
    middle = 0.5 * (numpy.array(begin) + end)
    axes.text(middle[0], middle[1] + 0.3, text, ha="center", va="bottom", fontsize=7)


def frame(axes, left, right, top, title):
    """True proportions, no ticks, the base below."""
    box(axes, left, right, -1, 0, BASE)
    axes.set_aspect("equal")
    axes.set_xlim(left, right)
    axes.set_ylim(-1, top)
    axes.set_axis_off()
    axes.set_title(title, loc="left", pad=2)


def draw_fill(axes, state):
    rear, gate = (x / state.diameter for x in fill_box(state))
    _, _, top = side_view(axes, state)
    thickness = rear - float(state.info["blade_start"]) / state.diameter
    clearance = float(state.info["clearance"]) / state.diameter
    box(axes, rear - thickness, rear, clearance, top + 4)
    box(axes, rear - 0.15 * thickness, rear, 0, clearance, "white")
    box(axes, gate, gate + 1, 0, top + 4, "white")
    axes.text(rear - 0.5 * thickness, top + 4.4, "blade", ha="center", fontsize=7)
    axes.text(gate + 0.5, top + 4.4, "gate", ha="center", fontsize=7)
    frame(axes, rear - thickness - 2, gate + 5, top + 7, "(a) fill")


def draw_heap(axes, state):
    rear, gate = (x / state.diameter for x in fill_box(state))
    thickness = rear - float(state.info["blade_start"]) / state.diameter
    _, last, top = side_view(axes, state)
    box(axes, rear - thickness, rear, float(state.info["clearance"]) / state.diameter, top + 6)
    arrow(axes, (rear + 3, top + 3), (rear + 27, top + 3), "blade speed")
    frame(axes, rear - thickness - 2, max(last, gate) + 3, top + 8, "(b) heap")


def draw_layer(axes, layer):
    state = layer.state
    first, last, top = side_view(axes, state)
    start, end, _, _, bottom, _ = blade_bounds(state, layer.width)
    box(axes, start, end, bottom, top + 3)
    axes.plot([start - 4, start], [bottom, bottom], color="black", linewidth=0.6)
    axes.text(start - 2, bottom + 0.4, r"clearance $\delta$", ha="right", va="bottom", fontsize=7)
    begin, stop = layer.x_range
    arrow(axes, (begin, 6), (stop, 6), f"analysed: {stop - begin:.0f} $d_p$", "<->")
    for x in (begin, stop):
        axes.plot([x, x], [0, 7.5], "--", color="black", linewidth=0.6)
    frame(axes, min(first, begin) - 3, max(last, end) + 3, top + 4, "(c) spread")


def draw(layer, fill, heap):
    figure = pyplot.figure(figsize=(PAGE, 0.55 * PAGE))
    above, below = figure.subfigures(2, 1, height_ratios=[3, 1])
    left, right = above.subplots(1, 2)
    draw_fill(left, fill)
    draw_heap(right, heap)
    draw_layer(below.subplots(), layer)
    return figure


if __name__ == "__main__":
    with logged(snakemake):
        case, (fill, heap, spread) = snakemake.params.cases[0], map(str, snakemake.input.states)
        layer = Layer(case["bond"], case["ratio"], case["seed"], str(snakemake.input.metrics[0]), spread, {})
        note = f"A slice of {DEPTH} d_p along y."
        save(draw(layer, read_state(fill), read_state(heap)), snakemake, [layer], note)
