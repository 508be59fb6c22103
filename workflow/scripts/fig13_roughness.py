"""Figure 13: surface roughness against the Bond number."""

from layers import by_bond, load_layers
from reporting import logged
from style import COLUMN, bond_axis, bond_series, pyplot, save


def roughness_of(layer):
    """Ra of the analyser with the 95 % interval of its map [d_p]."""
    return layer.estimate("height", "Ra")


def draw(layers):
    figure, axes = pyplot.subplots(figsize=(COLUMN, 0.75 * COLUMN))
    groups = by_bond(layers)
    bond_series(axes, groups, roughness_of)
    bond_axis(axes, list(groups))
    axes.set_ylim(bottom=0)
    axes.set_ylabel(r"Surface roughness $Ra/d_p$ [–]")
    return figure


if __name__ == "__main__":
    with logged(snakemake):
        layers = load_layers(snakemake)
        save(draw(layers), snakemake, layers)
