"""Figure 16: share of the pores in six groups of size: (a) density pores, (b) chamber pores."""

from layers import by_bond, load_layers
from pore_metrics import CHAMBER, DENSITY, FEWEST, GROUPS
from reporting import logged
from style import PAGE, bond_colours, bond_label, grouped_bars, mean_and_range, pyplot, save


def shares_of(members, group):
    """Mean shares with bootstrap interval (one run) or range (several)."""
    return mean_and_range([layer.estimate(group, "group_number_fraction") for layer in members])


def count_of(members, group):
    """Pores of all runs."""
    return round(sum(layer.estimate(group, "count")[0] for layer in members))


def draw_panel(axes, groups, colours, group):
    """Bars of every Bond number side by side in each group of size; shares of fewer than FEWEST pores mean nothing."""
    series, errors = {}, {}
    for bond, members in groups.items():
        count = count_of(members, group)
        label = bond_label(bond, count)
        if count < FEWEST:
            axes.bar([0], [0], 0, color="none", label=f"{label}: no bars")
            continue
        value, lower, upper = (100 * part for part in shares_of(members, group))
        series[label], errors[label] = (value, colours[bond]), (lower, upper)
    if series:
        grouped_bars(axes, GROUPS, series, errors)
    else:
        axes.set_ylim(0, 100)
    axes.set_xticks(range(len(GROUPS)), GROUPS)
    axes.set_xlim(-0.5, len(GROUPS) - 0.5)
    axes.set_xlabel(r"Diameter $D/d_p$ [–]")
    axes.set_ylabel("Share of pores [%]")
    axes.legend(ncols=2)


def draw(layers):
    groups = by_bond(layers)
    colours = bond_colours(groups)
    figure, (upper, lower) = pyplot.subplots(2, 1, figsize=(PAGE, 0.7 * PAGE))
    draw_panel(upper, groups, colours, DENSITY)
    draw_panel(lower, groups, colours, CHAMBER)
    upper.set_title("(a) density pores")
    lower.set_title("(b) chamber pores")
    return figure


if __name__ == "__main__":
    with logged(snakemake):
        layers = load_layers(snakemake)
        save(draw(layers), snakemake, layers)
