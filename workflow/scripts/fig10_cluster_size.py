"""Figure 10: share of particles by the size of their cluster."""

from itertools import pairwise

import numpy

from layers import by_bond, load_layers
from reporting import logged
from replicates import over_replicates
from style import bond_colours, bond_label, bond_panels, grouped_bars, legend_above, panels_below_each_other, particles_of, save


def size_classes(layer):
    """First and last size of each class of the report but that of single particles; the last class is open."""
    first = [int(size) for size in layer.metrics["uncertainty"]["clusters"]["size_class_fraction"]["items"]]
    return [(size, following - 1) for size, following in pairwise(first[1:])] + [(first[-1], None)]


def class_label(first, last):
    """2, 5–8, ≥ 65."""
    if last is None:
        return f"≥ {first}"
    return str(first) if first == last else f"{first}–{last}"


def shares_of(groups):
    """Shares of size_classes with their intervals; see over_replicates."""
    return over_replicates(
        groups, lambda layer: [part[1:] for part in layer.estimate("clusters", "size_class_fraction")]
    )


def draw(layers):
    groups = by_bond(layers)
    colours = bond_colours(groups)
    panels = bond_panels(groups)
    results = shares_of(groups)
    figure, rows = panels_below_each_other(len(panels), 0.6)
    for axes, (title, bonds) in zip(rows, panels):
        used = numpy.flatnonzero(numpy.any([results[bond][0] > 0 for bond in bonds], axis=0))
        sizes = size_classes(layers[0])
        names = {bond: bond_label(bond, particles_of(groups[bond])) for bond in bonds}
        grouped_bars(
            axes,
            [class_label(*sizes[k]) for k in used],
            {names[bond]: (100 * results[bond][0][used], colours[bond]) for bond in bonds},
            {names[bond]: (100 * results[bond][1][used], 100 * results[bond][2][used]) for bond in bonds},
            {names[bond]: particles_of(groups[bond]) for bond in bonds},
        )
        axes.set_ylabel("Share of particles [%]")
        legend_above(axes, title)
    rows[-1].set_xlabel("Cluster size [particles]")
    return figure


if __name__ == "__main__":
    with logged(snakemake):
        layers = load_layers(snakemake)
        save(draw(layers), snakemake, layers)
