"""Figure 6: share of particles by coordination number."""

import numpy

from layers import by_bond, load_layers
from reporting import logged
from style import PAGE, bond_colours, bond_label, bond_panels, grouped_bars, mean_and_range, particles_of, pyplot, save


def padded(shares, count):
    """Shares of CN = 0..count - 1; no particle has a larger number than the list tells."""
    return numpy.pad(shares, (0, count - len(shares)))


def coordination_shares(members, largest):
    """Mean over the seeds of the shares of CN = 0..largest, with the bootstrap interval or the range of the seeds."""
    return mean_and_range(
        [[padded(part, largest + 1) for part in layer.estimate("clusters", "cn_fraction")] for layer in members]
    )


def draw(layers):
    groups = by_bond(layers)
    colours = bond_colours(groups)
    largest = max(len(layer.metrics["clusters"]["cn_counts"]) - 1 for layer in layers)
    panels = bond_panels(groups)
    figure, row = pyplot.subplots(1, len(panels), figsize=(PAGE, 0.38 * PAGE), sharey=True, squeeze=False)
    for axes, (title, bonds) in zip(row[0], panels):
        results = {
            bond_label(bond, particles_of(groups[bond])): (colours[bond], *coordination_shares(groups[bond], largest))
            for bond in bonds
        }
        grouped_bars(
            axes,
            [str(number) for number in range(largest + 1)],
            {label: (100 * value, colour) for label, (colour, value, _, _) in results.items()},
            {label: (100 * lower, 100 * upper) for label, (_, _, lower, upper) in results.items()},
        )
        axes.set_title(title)
        axes.set_xlabel("Coordination number [–]")
        axes.legend()
    row[0][0].set_ylabel("Share of particles [%]")
    return figure


if __name__ == "__main__":
    with logged(snakemake):
        layers = load_layers(snakemake)
        save(draw(layers), snakemake, layers)
