"""Figure 12: share of the layer's area by surface height."""

import numpy

from layers import by_bond, load_layers
from reporting import logged
from style import PAGE, bond_colours, bond_label, bond_panels, grouped_bars, mean_and_range, pyplot, save


LOWEST = 0.75  # d_p; below are only the flanks of spheres, in one class
STEP = 0.25  # d_p
EDGE = 1e-6  # a height this little above an edge counts as on it, as in the report


def class_edges(layers):
    """Upper edges of the height classes above that of the empty nodes [d_p]."""
    top = max(layer.height.max() for layer in layers)
    count = max(1, int(numpy.ceil((top - LOWEST) / STEP - EDGE)))
    return LOWEST + STEP * numpy.arange(count + 1)


def height_shares(layer, edges):
    """Share of empty nodes, then of each class of height, closed above, with the interval of blocks along x."""
    number = numpy.searchsorted(numpy.append(0, edges), layer.height - EDGE)
    classes = numpy.stack([number == k for k in range(len(edges) + 1)], axis=-1)

    def shares(rows):
        return rows.mean(axis=(0, 1))

    return shares(classes), *layer.interval(classes, shares)


def draw(layers):
    groups = by_bond(layers)
    colours = bond_colours(groups)
    edges = class_edges(layers)
    labels = ["0\n(empty)", f"0–\n{LOWEST:g}"] + [f"{edge - STEP:g}–\n{edge:g}" for edge in edges[1:]]
    panels = bond_panels(groups)
    figure, row = pyplot.subplots(1, len(panels), figsize=(PAGE, 0.4 * PAGE), sharey=True, squeeze=False)
    for axes, (title, bonds) in zip(row[0], panels):
        results = {
            bond: [100 * part for part in mean_and_range([height_shares(layer, edges) for layer in groups[bond]])]
            for bond in bonds
        }
        grouped_bars(
            axes,
            labels,
            {bond_label(bond): (value, colours[bond]) for bond, (value, _, _) in results.items()},
            {bond_label(bond): (lower, upper) for bond, (_, lower, upper) in results.items()},
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
