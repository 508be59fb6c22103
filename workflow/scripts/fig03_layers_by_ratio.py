"""Figure 3: layers from above and their local packing density at every stiffness ratio."""

from fig05_layer_maps import draw_rows
from layers import by_case, load_layers
from reporting import logged
from style import bond_label, save


def draw(layers):
    """One run of each Bond number and ratio, from the stiffest on."""
    groups = sorted(by_case(layers).items(), key=lambda item: (item[0][0], -item[0][1]))
    shown = [members[0] for _, members in groups]
    return draw_rows(shown, [f"{bond_label(layer.bond)}, ratio {layer.ratio:g}" for layer in shown])


if __name__ == "__main__":
    with logged(snakemake):
        layers = load_layers(snakemake)
        save(draw(layers), snakemake, layers, "One seed of each case is shown.")
