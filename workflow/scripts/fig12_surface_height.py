"""Figure 12: share of the layer's area by surface height."""

import numpy

from layers import by_bond, load_layers
from reporting import logged
from replicates import over_replicates
from style import bond_colours, bond_label, bond_panels, grouped_bars, legend_above, panels_below_each_other, save

LOWEST, HIGHEST = 0.75, 1.5  # d_p; below are only the flanks of spheres, above is what stands out of the clearance
STEP = 0.25  # d_p
EDGE = 1e-6  # a height this little above an edge counts as on it, as in the report


def class_edges(layers):
    """Upper edges of the height classes above that of the empty nodes [d_p]; the last class is open where needed."""
    top = max(layer.height.max() for layer in layers)
    count = max(1, int(numpy.ceil((min(top, HIGHEST) - LOWEST) / STEP - EDGE)))
    edges = LOWEST + STEP * numpy.arange(count + 1)
    return numpy.append(edges, numpy.inf) if top > HIGHEST + EDGE else edges


def class_labels(edges):
    """Of the empty nodes and of every class."""
    closed = [f"{edge - STEP:g}–\n{edge:g}" for edge in edges[1:] if numpy.isfinite(edge)]
    return ["0\n(empty)", f"0–\n{LOWEST:g}"] + closed + ([f"> {HIGHEST:g}"] if numpy.isinf(edges[-1]) else [])


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
    labels = class_labels(edges)
    panels = bond_panels(groups)
    shares = over_replicates(groups, lambda layer: height_shares(layer, edges))
    figure, row = panels_below_each_other(len(panels), 0.6)
    for axes, (title, bonds) in zip(row, panels):
        results = {bond: [100 * part for part in shares[bond]] for bond in bonds}
        grouped_bars(
            axes,
            labels,
            {bond_label(bond): (value, colours[bond]) for bond, (value, _, _) in results.items()},
            {bond_label(bond): (lower, upper) for bond, (_, lower, upper) in results.items()},
            {bond_label(bond): sum(layer.height.size for layer in groups[bond]) for bond in bonds},
        )
        axes.set_ylabel("Share of grid nodes [%]")
        legend_above(axes, title, columns=4)
    row[-1].set_xlabel(r"Surface height $z/d_p$ [–]")
    return figure


if __name__ == "__main__":
    with logged(snakemake):
        layers = load_layers(snakemake)
        save(draw(layers), snakemake, layers)
