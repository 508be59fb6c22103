"""One look for all figures: print sizes, colours that survive colour blindness and grey print, sources beside them."""

import matplotlib

matplotlib.use("Agg")

import matplotlib.pyplot as pyplot
import numpy
from matplotlib.colors import BoundaryNorm, ListedColormap
from matplotlib.patheffects import withStroke
from matplotlib.transforms import offset_copy

from reporting import write_json

WIDTH = 90 / 25.4  # of every figure, a column of a journal [inches]; texts are as large as they are printed
MARKERS = "osD^vP*Xhd"
PACKING_MAP = "magma"

pyplot.rcParams.update(
    {
        "font.size": 8,
        "axes.titlesize": 8,
        "axes.labelsize": 8,
        "legend.fontsize": 7,
        "xtick.labelsize": 7,
        "ytick.labelsize": 7,
        "axes.linewidth": 0.6,
        "lines.linewidth": 1.2,
        "lines.markersize": 4,
        "legend.frameon": False,
        "axes.spines.top": False,
        "axes.spines.right": False,
        "savefig.dpi": 600,  # a sphere of a map is half a millimetre wide
        "pdf.fonttype": 42,
        "figure.constrained_layout.use": True,
    }
)


LINES = ["-", "--", "-.", ":", (0, (5, 1, 1, 1, 1, 1))]
HALO = [withStroke(linewidth=2.0, foreground="white")]  # so that dark bars do not swallow black lines


def bond_colours(bonds):
    """A colour for each Bond number, dark to light as cohesion grows; the lightest still stands out from paper."""
    palette = matplotlib.colormaps["viridis"](numpy.linspace(0.0, 0.75, max(2, len(bonds))))
    return dict(zip(sorted(bonds), palette))


def bond_label(bond, count=None):
    """A layer on its own may be of an unknown Bond number; `count` is what its shares are shares of."""
    name = "layer" if bond is None else f"Bo = {bond:g}"
    return name if count is None else f"{name} (n = {count})"


def particles_of(members):
    """Particles in the analysed regions of the runs of one Bond number."""
    return sum(layer.metrics["clusters"]["n_particles"] for layer in members)


def error_bars(axes, x, values, lower, upper, **style):
    """Intervals in black on white, where they are known and have a length."""
    x, values, lower, upper = (numpy.asarray(part, dtype=float) for part in (x, values, lower, upper))
    known = numpy.isfinite(lower) & numpy.isfinite(upper) & (upper > lower)
    gap = [numpy.maximum(values - lower, 0)[known], numpy.maximum(upper - values, 0)[known]]
    style = {"ecolor": "black", "elinewidth": 0.7, "capsize": 1.3, "capthick": 0.7, "zorder": 4} | style
    drawn = axes.errorbar(x[known], values[known], gap, fmt="none", **style)
    for part in (*drawn[1], *drawn[2]):
        part.set_path_effects(HALO)


def bond_panels(bonds):
    """The paper's two panels, Bo <= 1 and Bo >= 1; a panel without a Bond number of its own is left out."""
    if None in bonds:
        return [("", list(bonds))]
    weak = [bond for bond in bonds if bond <= 1]
    strong = [bond for bond in bonds if bond >= 1]
    if not any(bond < 1 for bond in weak):
        return [("", strong)]
    if not any(bond > 1 for bond in strong):
        return [("", weak)]
    return [("(a) Bo ≤ 1", weak), ("(b) Bo ≥ 1", strong)]


def bond_axis(axes, bonds):
    """A Bond number axis that shows 0 as well: linear to 1, logarithmic beyond."""
    axes.set_xscale("symlog", linthresh=1, linscale=0.6)
    axes.set_xticks(bonds, [f"{bond:g}" for bond in bonds])
    axes.tick_params(axis="x", which="minor", bottom=False)
    if len(bonds) > 6:
        axes.tick_params(axis="x", labelrotation=60)
    axes.set_xlabel("Bond number Bo [–]")


def coordination_colours(largest):
    """Colour map and norm of the coordination number 0, 1, ..., the last class open above 5."""
    classes = min(max(largest, 4), 5) + 1
    colours = ListedColormap(matplotlib.colormaps["viridis"](numpy.linspace(0, 1, classes)))
    return colours, BoundaryNorm(numpy.arange(classes + 1) - 0.5, classes), classes


def coordination_ticks(classes):
    """Labels of the classes of coordination_colours."""
    return [str(number) if number < 5 else "≥ 5" for number in range(classes)]


FEW = 10  # members of a bar, below which their number stands over it


def few(axes, places, tops, counts):
    """Numbers of members over the bars that have few; tops: where bars and their intervals end."""
    for place, top, count in zip(places, tops, numpy.round(counts).astype(int)):
        if 0 < count < FEW:
            axes.text(place, top, f"{count}", ha="center", va="bottom", fontsize=5.5)


def grouped_bars(axes, categories, series, errors, totals):
    """Bars of shares [%] side by side, with numbers of members where they are few.

    series: label -> (values, colour); errors: label -> (lower, upper); totals: label -> how many make 100 %.
    """
    place = numpy.arange(len(categories))
    width = 0.82 / len(series)
    for number, (label, (values, colour)) in enumerate(series.items()):
        left = place - 0.41 + (number + 0.5) * width
        axes.bar(left, values, width, color=colour, edgecolor="black", linewidth=0.3, label=label)
        lower, upper = errors[label]
        lower, upper = numpy.maximum(lower, 0), numpy.minimum(upper, 100)  # shares
        error_bars(axes, left, values, lower, upper)
        few(axes, left, numpy.fmax(values, upper), totals[label] * numpy.asarray(values) / 100)
    axes.set_ylim(bottom=0)
    axes.set_xticks(place, categories)


def bond_series(axes, groups, results, statistic, places=None):
    """A statistic of each Bond number with its interval, and the runs where there are several; results: over_replicates.

    No line joins them, since nothing is known in between. `places`: x of each, by default the Bond number itself.
    """
    places = list(groups) if places is None else places
    colours = bond_colours(groups)
    for place, (bond, members) in zip(places, groups.items()):
        value, lower, upper = (float(part) for part in results[bond])
        if numpy.isfinite(value):
            error_bars(axes, [place], [value], [lower], [upper], elinewidth=0.9, capsize=2.5)
            style = {"markersize": 5, "markeredgecolor": "black", "markeredgewidth": 0.5}
            axes.plot([place], [value], "o", color=colours[bond], zorder=5, **style)
        if len(members) > 1:
            runs = [statistic(layer)[0] for layer in members]
            axes.plot([place] * len(members), runs, "_", color="black", markersize=8, markeredgewidth=0.8, zorder=3)


def panels_below_each_other(count, height):
    """Figure and axes of panels that fill the width; height of each as a share of it."""
    figure, panels = pyplot.subplots(count, 1, figsize=(WIDTH, count * height * WIDTH), squeeze=False)
    return figure, panels[:, 0]


def legend_above(axes, title="", columns=2, **more):
    """Title and legend of a panel between it and the one above."""
    axes.legend(
        title=title,
        title_fontsize=8,
        alignment="left",
        loc="lower left",
        bbox_to_anchor=(-0.02, 0.98),
        ncols=columns,
        columnspacing=0.9,
        handlelength=1.8,
        handletextpad=0.4,
        borderaxespad=0,
        **more,
    )


def scale_bar(axes):
    """A bar of 10 d_p, or fewer on a short map, above the upper right corner of a map, and its length."""
    (left, right), (_, high) = axes.get_xlim(), axes.get_ylim()
    length = next((length for length in (10, 5, 2) if length <= 0.4 * (right - left)), 1)
    place = {"transform": offset_copy(axes.transData, axes.figure, y=5, units="points"), "clip_on": False}
    axes.plot([right - length, right], [high, high], color="black", linewidth=2, solid_capstyle="butt", **place)
    axes.text(right - length, high, f"{length} $d_p$ ", ha="right", va="center", fontsize=7, **place)


def save(figure, snakemake, layers, note=""):
    """Write the figure as PDF and PNG, and beside it what it was drawn from."""
    figure.savefig(snakemake.output.vector, metadata={"CreationDate": None})
    figure.savefig(snakemake.output.bitmap, metadata={"Software": None})
    pyplot.close(figure)
    write_sources(snakemake.output.sources, layers, note)


def write_sources(path, layers, note=""):
    """Runs, seeds, program versions and files behind a figure."""
    write_json(
        path,
        {
            "bond_numbers": sorted({layer.bond for layer in layers}),
            "stiffness_ratios": sorted({layer.ratio for layer in layers}),
            "seeds": sorted({layer.seed for layer in layers}),
            "versions": sorted({str(layer.state.info["program_version"]) for layer in layers}),
            "files": [layer.metrics_path for layer in layers],
            "note": note,
        },
    )
