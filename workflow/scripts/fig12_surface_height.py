"""Figure 12: share of the layer's area by surface height."""

import numpy

from layers import by_bond, load_layers
from reporting import logged
from style import PAGE, bond_colours, bond_label, bond_panels, grouped_bars, pyplot, save


def class_edges(layers):
    """Upper edges of the height classes, the longest list of any layer."""
    return max((layer.metrics["height"]["bin_upper_edges"] for layer in layers), key=len)


def height_shares(layer, count):
    """Share of empty nodes, then of each class of height, with intervals."""
    empty, classes = layer.estimate("height", "empty_fraction"), layer.estimate("height", "fraction")
    return [numpy.pad(numpy.append(e, c), (0, count - len(c))) for e, c in zip(empty, classes, strict=True)]


def shares_of(members, edges):
    """Mean shares with bootstrap interval (one run) or range (several)."""
    results = [height_shares(layer, len(edges)) for layer in members]
    if len(results) == 1:
        return results[0]
    values = numpy.array([value for value, _, _ in results])
    return values.mean(axis=0), values.min(axis=0), values.max(axis=0)


def draw(layers):
    groups = by_bond(layers)
    colours = bond_colours(groups)
    edges = class_edges(layers)
    labels = ["0"] + [f"{edge - edges[0]:g}–\n{edge:g}" for edge in edges]
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
