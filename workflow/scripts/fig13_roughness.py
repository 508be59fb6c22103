"""Figure 13: surface roughness against the Bond number."""

from layers import by_bond, load_layers
from reporting import logged
from replicates import over_replicates
from style import WIDTH, bond_axis, bond_series, pyplot, save


def roughness_of(layer):
    """Ra of the analyser with the 95 % interval of its map [d_p]."""
    return layer.estimate("height", "Ra")


def draw(layers):
    figure, axes = pyplot.subplots(figsize=(WIDTH, 0.75 * WIDTH))
    groups = by_bond(layers)
    bond_series(axes, groups, over_replicates(groups, roughness_of), roughness_of)
    bond_axis(axes, list(groups))
    axes.set_ylim(bottom=0)
    axes.set_ylabel(r"Surface roughness $Ra/d_p$ [–]")
    return figure


if __name__ == "__main__":
    with logged(snakemake):
        layers = load_layers(snakemake)
        save(draw(layers), snakemake, layers)
