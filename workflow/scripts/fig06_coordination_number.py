"""Figure 6: share of particles by coordination number."""

import numpy

from layers import by_bond, load_layers
from reporting import logged
from replicates import over_replicates
from style import bond_colours, bond_label, bond_panels, grouped_bars, legend_above, panels_below_each_other, particles_of, save


def padded(shares, count):
    """Shares of CN = 0..count - 1; no particle has a larger number than the list tells."""
    return numpy.pad(shares, (0, count - len(shares)))


def coordination_shares(groups, largest):
    """Shares of CN = 0..largest with their intervals; see over_replicates."""
    return over_replicates(
        groups, lambda layer: [padded(part, largest + 1) for part in layer.estimate("clusters", "cn_fraction")]
    )


def draw(layers):
    groups = by_bond(layers)
    colours = bond_colours(groups)
    largest = max(len(layer.metrics["clusters"]["cn_counts"]) - 1 for layer in layers)
    shares = coordination_shares(groups, largest)
    panels = bond_panels(groups)
    figure, row = panels_below_each_other(len(panels), 0.6)
    for axes, (title, bonds) in zip(row, panels):
        names = {bond: bond_label(bond, particles_of(groups[bond])) for bond in bonds}
        grouped_bars(
            axes,
            [str(number) for number in range(largest + 1)],
            {names[bond]: (100 * shares[bond][0], colours[bond]) for bond in bonds},
            {names[bond]: (100 * shares[bond][1], 100 * shares[bond][2]) for bond in bonds},
            {names[bond]: particles_of(groups[bond]) for bond in bonds},
        )
        axes.set_ylabel("Share of particles [%]")
        legend_above(axes, title)
    row[-1].set_xlabel("Coordination number [–]")
    return figure


if __name__ == "__main__":
    with logged(snakemake):
        layers = load_layers(snakemake)
        save(draw(layers), snakemake, layers)
