"""Figure 16: share of the pores in six groups of size: (a) density pores, (b) chamber pores."""

from layers import by_bond, load_layers
from pore_metrics import CHAMBER, DENSITY, FEWEST, GROUPS
from reporting import logged
from replicates import over_replicates
from style import bond_colours, bond_label, grouped_bars, legend_above, panels_below_each_other, save


def count_of(members, group):
    """Pores of all runs."""
    return round(sum(layer.estimate(group, "count")[0] for layer in members))


def draw_panel(axes, groups, colours, group, title):
    """Bars of every Bond number side by side in each group of size; shares of fewer than FEWEST pores mean nothing."""
    series, errors, totals = {}, {}, {}
    enough = {bond: members for bond, members in groups.items() if count_of(members, group) >= FEWEST}
    shares = over_replicates(enough, lambda layer: layer.estimate(group, "group_number_fraction")) if enough else {}
    for bond, members in groups.items():
        count = count_of(members, group)
        label = bond_label(bond, count)
        if bond not in shares:
            axes.bar([0], [0], 0, color="none", label=f"{label}: no bars")
            continue
        value, lower, upper = (100 * part for part in shares[bond])
        series[label], errors[label], totals[label] = (value, colours[bond]), (lower, upper), count
    if series:
        grouped_bars(axes, GROUPS, series, errors, totals)
    else:
        axes.set_ylim(0, 100)
    axes.set_xticks(range(len(GROUPS)), GROUPS)
    axes.set_xlim(-0.5, len(GROUPS) - 0.5)
    axes.set_ylabel("Share of pores [%]")
    legend_above(axes, title)


def draw(layers):
    groups = by_bond(layers)
    colours = bond_colours(groups)
    figure, (above, below) = panels_below_each_other(2, 0.65)
    draw_panel(above, groups, colours, DENSITY, "(a) density pores")
    draw_panel(below, groups, colours, CHAMBER, "(b) chamber pores")
    above.set_xlabel(r"Equivalent diameter of density pore $D/d_p$ [–]")
    below.set_xlabel(r"Diameter of chamber pore $D/d_p$ [–]")
    return figure


if __name__ == "__main__":
    with logged(snakemake):
        layers = load_layers(snakemake)
        save(draw(layers), snakemake, layers)
