"""One look for all figures: print sizes, colours that survive colour blindness and grey print, sources beside them."""

import matplotlib

matplotlib.use("Agg")

import matplotlib.pyplot as pyplot
import numpy
from matplotlib.colors import BoundaryNorm, ListedColormap
from matplotlib.patheffects import withStroke

from reporting import write_json

COLUMN = 90 / 25.4  # inches
PAGE = 180 / 25.4
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
        "savefig.dpi": 300,
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


def mean_and_range(results):
    """(value, lower, upper) of one run as they are; of several runs their mean and their range."""
    if len(results) == 1:
        return tuple(numpy.asarray(part, dtype=float) for part in results[0])
    values = numpy.array([value for value, _, _ in results], dtype=float)
    return values.mean(axis=0), values.min(axis=0), values.max(axis=0)


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


def grouped_bars(axes, categories, series, errors=None):
    """Bars of several series side by side; series: label -> (values, colour); errors: label -> (lower, upper)."""
    place = numpy.arange(len(categories))
    width = 0.82 / len(series)
    for number, (label, (values, colour)) in enumerate(series.items()):
        left = place - 0.41 + (number + 0.5) * width
        axes.bar(left, values, width, color=colour, edgecolor="black", linewidth=0.3, label=label)
        if errors:
            error_bars(axes, left, values, *errors[label])
    axes.set_xticks(place, categories)


def bond_series(axes, groups, statistic, places=None):
    """A statistic of each Bond number: bootstrap interval of a single run, or the runs about their mean.

    No line joins them, since nothing is known in between. `places`: x of each, by default the Bond number itself.
    """
    places = list(groups) if places is None else places
    for place, members in zip(places, groups.values()):
        results = [statistic(layer) for layer in members]
        value, lower, upper = mean_and_range(results)
        if numpy.isfinite(value):
            error_bars(axes, [place], [value], [lower], [upper], elinewidth=0.9, capsize=2.5)
            axes.plot([place], [value], "o", color="C0", markeredgecolor="black", markeredgewidth=0.4, zorder=5)
        if len(members) > 1:
            axes.plot([place] * len(members), [result[0] for result in results], ".", color="0.4", markersize=3, zorder=5)


def scale_bar(axes):
    """A bar of 10 d_p, or fewer on a short map, in the lower right corner of a map, and its length."""
    (left, right), (low, high) = axes.get_xlim(), axes.get_ylim()
    length = next((length for length in (10, 5, 2) if length <= 0.4 * (right - left)), 1)
    x, y = right - 0.02 * (right - left), low + 0.1 * (high - low)
    bar = axes.plot([x - length, x], [y, y], color="black", linewidth=2, solid_capstyle="butt", zorder=8)
    label = axes.text(x - 0.5 * length, y, f"{length} $d_p$", ha="center", va="bottom", fontsize=7, zorder=8)
    for part in (*bar, label):
        part.set_path_effects([withStroke(linewidth=3.5, foreground="white")])


def save(figure, snakemake, layers, note=""):
    """Write the figure as PDF and 300 dpi PNG, and beside it what it was drawn from."""
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
