"""Figure 10: share of particles by the size of their cluster."""

import numpy

from layers import by_bond, load_layers
from reporting import logged
from style import PAGE, bond_colours, bond_label, bond_panels, grouped_bars, pyplot, save

CLASSES = [(2, 2), (3, 3), (4, 4), (5, 8), (9, 16), (17, 32), (33, 64), (65, None)]


def class_label(first, last):
    """2, 5–8, ≥ 65."""
    if last is None:
        return f"≥ {first}"
    return str(first) if first == last else f"{first}–{last}"


def class_shares(size_fraction):
    """Share of all particles in each class of cluster size, from the share of each size."""
    return numpy.array(
        [
            sum(
                share
                for size, share in size_fraction.items()
                if int(size) >= first and int(size) <= (last or int(size))
            )
            for first, last in CLASSES
        ]
    )


def class_of(sizes):
    """Class number of each particle's cluster size; -1 for single particles."""
    return numpy.searchsorted([first for first, _ in CLASSES], sizes, side="right") - 1


def shares_of(members):
    """Mean shares with bootstrap interval (one run) or range (several)."""
    values = numpy.array([class_shares(layer.metrics["clusters"]["size_fraction"]) for layer in members])
    if len(members) > 1:
        return values.mean(axis=0), values.min(axis=0), values.max(axis=0)
    layer = members[0]
    with_single = class_of(layer.cluster_size) + 1
    _, lower, upper = layer.share_interval(with_single, len(CLASSES) + 1)
    return values[0], lower[1:], upper[1:]


def draw(layers):
    groups = by_bond(layers)
    colours = bond_colours(groups)
    panels = bond_panels(groups)
    results = {bond: shares_of(members) for bond, members in groups.items()}
    used = max(numpy.flatnonzero(values).max(initial=1) for values, _, _ in results.values()) + 1
    labels = [class_label(*sizes) for sizes in CLASSES][:used]
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
