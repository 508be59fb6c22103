"""Figure 12: share of the layer's area by surface height."""

import numpy

from layers import by_bond, load_layers
from reporting import logged
from style import PAGE, bond_colours, bond_label, bond_panels, grouped_bars, pyplot, save


def class_edges(layers):
    """Upper edges of the height classes, the longest list of any layer."""
    return max((layer.metrics["height"]["bin_upper_edges"] for layer in layers), key=len)


def height_shares(layer, count):
    """Share of empty nodes, then of each class of height."""
    fractions = layer.metrics["height"]["fraction"]
    return numpy.array([layer.metrics["height"]["empty_fraction"], *fractions, *[0.0] * (count - len(fractions))])


def class_counts(layer, count, width):
    """Nodes of each class in each row along x, [rows, classes]; classes are closed above."""
    number = numpy.where(layer.height > 0, numpy.ceil(layer.height / width - 1e-6).astype(int), 0)
    return numpy.stack([(number == group).sum(axis=1) for group in range(count + 1)], axis=1)


def node_shares(counts):
    """Shares of the classes over all rows."""
    return counts.sum(axis=0) / counts.sum()


def shares_of(members, edges):
    """Mean shares with bootstrap interval (one run) or range (several)."""
    values = numpy.array([height_shares(layer, len(edges)) for layer in members])
    if len(members) > 1:
        return values.mean(axis=0), values.min(axis=0), values.max(axis=0)
    counts = class_counts(members[0], len(edges), edges[0])
    return values[0], *members[0].interval(counts, node_shares)


def draw(layers):
    groups = by_bond(layers)
    colours = bond_colours(groups)
    edges = class_edges(layers)
    labels = ["0\n(empty)"] + [f"{edge - edges[0]:g}–\n{edge:g}" for edge in edges]
    panels = bond_panels(groups)
    figure, row = pyplot.subplots(1, len(panels), figsize=(PAGE, 0.4 * PAGE), sharey=True, squeeze=False)
    for axes, (title, bonds) in zip(row[0], panels):
        results = {bond: shares_of(groups[bond], edges) for bond in bonds}
        grouped_bars(
            axes,
            labels,
            {bond_label(bond): (100 * result[0], colours[bond]) for bond, result in results.items()},
            {bond_label(bond): (100 * result[1], 100 * result[2]) for bond, result in results.items()},
        )
        axes.set_title(title)
        axes.set_xlabel(r"Surface height $z/d_p$ [–]")
        axes.legend()
    row[0][0].set_ylabel("Share of grid nodes [%]")
    return figure


if __name__ == "__main__":
    with logged(snakemake):
        layers = load_layers(snakemake)
        save(draw(layers), snakemake, layers)
