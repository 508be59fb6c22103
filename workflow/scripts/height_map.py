"""The surface of a layer: the highest point over every cell of the grid."""

import numpy

from from_above import shown_length
from layers import by_bond, load_layers
from reporting import logged
from style import PAGE, bond_label, pyplot, save, scale_bar

HEIGHTS = "cividis"
EMPTY = "1.0"  # where no sphere stands


def draw(layers):
    shown = [members[0] for members in by_bond(layers).values()]
    length = shown_length(shown)
    highest = max(1.0, *(layer.height.max() for layer in shown))
    row = 0.85 * PAGE * shown[0].width / length + 0.25
    figure, panels = pyplot.subplots(
        len(shown), 1, figsize=(PAGE, len(shown) * row + 0.8), sharex=True, sharey=True, squeeze=False
    )
    colours = pyplot.get_cmap(HEIGHTS).with_extremes(bad=EMPTY)
    for axes, layer in zip(panels[:, 0], shown):
        heights = numpy.where(layer.height > 0, layer.height, numpy.nan)[: round(length)]
        extent = (layer.x_range[0], layer.x_range[0] + length, 0, layer.width)
        image = axes.imshow(
            heights.T, origin="lower", extent=extent, vmin=0, vmax=highest, cmap=colours, interpolation="nearest"
        )
        axes.spines[["top", "right"]].set_visible(True)
        axes.set_ylabel(f"{bond_label(layer.bond)}\n$y/d_p$")
    scale_bar(panels[0][0])
    panels[-1][0].set_xlabel(r"$x/d_p$ [–] (spreading direction)")
    bar = figure.colorbar(image, ax=panels[:, 0], location="bottom", shrink=0.6, aspect=35)
    bar.set_label(r"Highest point over the cell $z/d_p$ [–]; white: empty")
    return figure


if __name__ == "__main__":
    with logged(snakemake):
        layers = load_layers(snakemake)
        save(draw(layers), snakemake, layers)
