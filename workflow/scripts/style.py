"""One look for all figures: print sizes, colours that survive colour blindness and grey print, sources beside them."""

import matplotlib

matplotlib.use("Agg")

import matplotlib.pyplot as pyplot
import numpy
from matplotlib.colors import BoundaryNorm, ListedColormap

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


def bond_colours(bonds):
    """A colour for each Bond number, dark to light as cohesion grows."""
    palette = matplotlib.colormaps["viridis"](numpy.linspace(0.0, 0.88, max(2, len(bonds))))
    return dict(zip(sorted(bonds), palette))


def bond_label(bond):
    """A layer on its own may be of an unknown Bond number."""
    return "layer" if bond is None else f"Bo = {bond:g}"


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
            lower, upper = (numpy.asarray(bound) for bound in errors[label])
            known = upper > lower
            gap = [numpy.maximum(values - lower, 0)[known], numpy.maximum(upper - values, 0)[known]]
            axes.errorbar(left[known], values[known], gap, fmt="none", ecolor="black", elinewidth=0.6, capsize=1.2)
    axes.set_xticks(place, categories)


def bond_series(axes, groups, statistic):
    """A statistic of each Bond number: bootstrap interval of a single run, or the runs about their mean."""
    bonds = list(groups)
    means = [numpy.mean([statistic(layer)[0] for layer in members]) for members in groups.values()]
    axes.plot(bonds, means, color="black", linewidth=0.8, zorder=1)
    for bond, mean, members in zip(bonds, means, groups.values()):
        if len(members) == 1:
            value, lower, upper = statistic(members[0])
            gap = [[max(value - lower, 0)], [max(upper - value, 0)]]
            axes.errorbar([bond], [value], gap, fmt="o", color="C0", ecolor="black", elinewidth=0.8, capsize=2)
        else:
            axes.plot([bond] * len(members), [statistic(layer)[0] for layer in members], ".", color="C0")
            axes.plot([bond], [mean], "_", color="black", markersize=9)
    bond_axis(axes, bonds)


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
