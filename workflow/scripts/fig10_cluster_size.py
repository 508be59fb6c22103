"""Figure 10: share of particles by the size of their cluster."""

from itertools import pairwise

import numpy

from layers import by_bond, load_layers
from reporting import logged
from style import PAGE, bond_colours, bond_label, bond_panels, grouped_bars, pyplot, save


def size_classes(layer):
    """First and last size of each class of the report but that of single particles; the last class is open."""
    first = [int(size) for size in layer.metrics["uncertainty"]["clusters"]["size_class_fraction"]["items"]]
    return [(size, following - 1) for size, following in pairwise(first[1:])] + [(first[-1], None)]


def class_label(first, last):
    """2, 5–8, ≥ 65."""
    if last is None:
        return f"≥ {first}"
    return str(first) if first == last else f"{first}–{last}"


def shares_of(members):
    """Mean shares of size_classes with bootstrap interval (one run) or range (several)."""
    results = [layer.estimate("clusters", "size_class_fraction") for layer in members]
    if len(results) == 1:
        return [part[1:] for part in results[0]]
    values = numpy.array([value[1:] for value, _, _ in results])
    return values.mean(axis=0), values.min(axis=0), values.max(axis=0)


def draw(layers):
    groups = by_bond(layers)
    colours = bond_colours(groups)
    panels = bond_panels(groups)
    results = {bond: shares_of(members) for bond, members in groups.items()}
    used = max(numpy.flatnonzero(values).max(initial=1) for values, _, _ in results.values()) + 1
    labels = [class_label(*sizes) for sizes in size_classes(layers[0])][:used]
    figure, row = pyplot.subplots(1, len(panels), figsize=(PAGE, 0.4 * PAGE), sharey=True, squeeze=False)
    for axes, (title, bonds) in zip(row[0], panels):
        grouped_bars(
            axes,
            labels,
            {bond_label(bond): (100 * results[bond][0][:used], colours[bond]) for bond in bonds},
            {bond_label(bond): (100 * results[bond][1][:used], 100 * results[bond][2][:used]) for bond in bonds},
        )
        axes.set_title(title)
        axes.set_xlabel("Cluster size [particles]")
        axes.legend()
    row[0][0].set_ylabel("Share of particles [%]")
    return figure


if __name__ == "__main__":
    with logged(snakemake):
        layers = load_layers(snakemake)
        save(draw(layers), snakemake, layers)
