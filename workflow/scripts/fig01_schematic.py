"""Figure 1: the process and the analysed part of the layer, drawn from the states of a run."""

import numpy
from matplotlib.patches import Rectangle

from fig05_rendered_layer import blade_bounds
from from_side import spheres
from layers import Layer
from reporting import logged
from states import fill_box, read_state
from style import WIDTH, pyplot, save

DEPTH = 2  # of the slice along y that is shown [d_p]
SECTION = 110  # longest part of the spread layer that is shown, measured back from the front of the heap [d_p]
AHEAD = 40  # as much of the heap before the blade [d_p]
POWDER, STEEL, BASE = "#c9ad7c", "0.45", "0.8"


def side_view(axes, state):
    """Particles of a slice, the nearest on top; (x of the first, x of the last, highest z) of the slice [d_p]."""
    points = state.points / state.diameter
    shown = numpy.flatnonzero(points[:, 1] - float(state.info["y_min"]) / state.diameter < DEPTH)
    spheres(axes, state, shown, facecolors=POWDER, linewidths=0.15)
    return points[shown, 0].min(), points[shown, 0].max(), points[shown, 2].max()


def box(axes, left, right, bottom, top, colour=STEEL):
    """A wall seen from the side."""
    axes.add_patch(Rectangle((left, bottom), right - left, top - bottom, facecolor=colour, edgecolor="black", linewidth=0.5))


def arrow(axes, begin, end, text, style="-|>"):
    """An arrow, or a dimension, with its name above its middle."""
    axes.annotate("", end, begin, arrowprops={"arrowstyle": style, "linewidth": 0.7, "shrinkA": 0, "shrinkB": 0, "color": "black"})
    middle = 0.5 * (numpy.array(begin) + end)
    axes.annotate(text, middle, (0, 2), textcoords="offset points", ha="center", va="bottom", fontsize=7)


def name(axes, x, z, text):
    """A word above a place."""
    axes.annotate(text, (x, z), (0, 2), textcoords="offset points", ha="center", va="bottom", fontsize=7)


def frame(axes, left, right, top, title):
    """True proportions, no ticks, the base below."""
    axes.axhspan(-1, 0, facecolor=BASE, edgecolor="black", linewidth=0.5)
    axes.set_aspect("equal")
    axes.set_xlim(left, right)
    axes.set_ylim(-1, top)
    axes.set_axis_off()
    axes.set_title(title, loc="left", pad=2)


def blade_thickness(state):
    """In d_p."""
    return (fill_box(state)[0] - float(state.info["blade_start"])) / state.diameter


def draw_fill(axes, state):
    """Between the blade, which stands on the base, and the gate."""
    rear, gate = (x / state.diameter for x in fill_box(state))
    _, _, top = side_view(axes, state)
    thickness = blade_thickness(state)
    box(axes, rear - thickness, rear, 0, top + 4)
    axes.plot([gate, gate], [0, top + 4], color="black", linewidth=1.0)
    name(axes, rear - 0.5 * thickness, top + 4, "blade")
    name(axes, gate, top + 4, "gate")
    for letter, tip in (("$z$", (gate + 6, 8)), ("$x$", (gate + 13, 1))):
        style = {"arrowstyle": "<|-", "linewidth": 0.7, "color": "black", "shrinkB": 0}
        axes.annotate(letter, (gate + 6, 1), tip, ha="center", va="center", fontsize=7, arrowprops=style)
    frame(axes, rear - thickness - 2, gate + 15, top + 9, "(a) fill")


def draw_heap(axes, state):
    """The gate is gone and the powder at rest; the blade is about to be lifted and to set out."""
    rear, gate = (x / state.diameter for x in fill_box(state))
    _, last, top = side_view(axes, state)
    thickness = blade_thickness(state)
    box(axes, rear - thickness, rear, 0, top + 4)
    arrow(axes, (rear, top + 2.5), (rear + 14, top + 2.5), "  blade speed")
    frame(axes, rear - thickness - 2, max(min(last, gate + AHEAD), rear + 15) + 3, top + 9, "(b) heap")


def draw_layer(axes, layer):
    """The blade at the end of its way, the layer behind it and its analysed part."""
    state = layer.state
    _, last, _ = side_view(axes, state)
    start, end, _, _, bottom, _ = blade_bounds(state, layer.width)
    begin, stop = layer.x_range
    right = min(last, end + AHEAD) + 3
    left = max(begin - 6, right - SECTION)
    top = bottom + 9
    box(axes, start, end, bottom, top)
    name(axes, 0.5 * (start + end), top, rf"clearance $h_b$ = {bottom:g} $d_p$")
    first = max(begin, left)
    arrow(axes, (first, 5), (stop, 5), f"analysed: {stop - begin:.0f} $d_p$", "<|-|>" if begin > left else "-|>")
    for x in (begin, stop):
        axes.plot([x, x], [0, 6.5], "--", color="black", linewidth=0.6)
    frame(axes, left, right, top + 6, "(c) spread")


def share_scale(*panels):
    """The same size of a sphere in all panels, their left and lower edges kept."""
    width = max(numpy.ptp(axes.get_xlim()) for axes in panels)
    top = max(axes.get_ylim()[1] for axes in panels)
    for axes in panels:
        left = axes.get_xlim()[0]
        axes.set(xlim=(left, left + width), ylim=(-1, top))


def draw(layer, fill, heap):
    """Layer (analysed), states after fill and heap."""
    figure = pyplot.figure(figsize=(WIDTH, 0.72 * WIDTH))
    above, below = figure.subfigures(2, 1, height_ratios=[2.2, 1])
    left, right = above.subplots(1, 2)
    draw_fill(left, fill)
    draw_heap(right, heap)
    share_scale(left, right)
    draw_layer(below.subplots(), layer)
    return figure


if __name__ == "__main__":
    with logged(snakemake):
        case, (fill, heap, spread) = snakemake.params.cases[0], map(str, snakemake.input.states)
        layer = Layer(case["bond"], case["ratio"], case["seed"], str(snakemake.input.metrics[0]), spread, {})
        note = f"A slice of {DEPTH} d_p along y."
        save(draw(layer, read_state(fill), read_state(heap)), snakemake, [layer], note)
