"""Figure 16: share of the pores in six groups of size: (a) density pores, (b) chamber pores."""

import numpy

from layers import by_bond, load_layers
from pore_metrics import CHAMBER, DENSITY, GROUPS
from reporting import logged
from style import PAGE, bond_colours, bond_label, grouped_bars, pyplot, save


def shares_of(members, group):
    """Mean shares with bootstrap interval (one run) or range (several); none drawn where a layer has no such pores."""
    results = numpy.array([layer.estimate(group, "group_number_fraction") for layer in members])
    if len(results) > 1:
        values = results[:, 0]
        results = numpy.array([[values.mean(axis=0), values.min(axis=0), values.max(axis=0)]])
    return numpy.nan_to_num(results[0])


def draw_panel(axes, groups, colours, group):
    """Bars of every Bond number side by side in each group of size."""
    shares = {bond: 100 * shares_of(members, group) for bond, members in groups.items()}
    grouped_bars(
        axes,
        GROUPS,
        {bond_label(bond): (values, colours[bond]) for bond, (values, _, _) in shares.items()},
        {bond_label(bond): (lower, upper) for bond, (_, lower, upper) in shares.items()},
    )
    axes.set_ylabel("Share of pores [%]")


def draw(layers):
    groups = by_bond(layers)
    colours = bond_colours(groups)
    figure, (upper, lower) = pyplot.subplots(2, 1, figsize=(PAGE, 0.66 * PAGE))
    draw_panel(upper, groups, colours, DENSITY)
    draw_panel(lower, groups, colours, CHAMBER)
    upper.set_title("(a) density pores")
    lower.set_title("(b) chamber pores")
    upper.legend(ncols=2)
    lower.set_xlabel(r"Diameter $D/d_p$ [–]")
    return figure


if __name__ == "__main__":
    with logged(snakemake):
        layers = load_layers(snakemake)
        save(draw(layers), snakemake, layers)
