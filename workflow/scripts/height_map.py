"""The surface of a layer: the highest point over every cell of the grid."""

import numpy

from from_above import frame, name_row, rows_of_maps, shown_length
from layers import by_bond, load_layers
from reporting import logged
from style import bond_label, pyplot, save, scale_bar

HEIGHTS = "cividis"
EMPTY = "1.0"  # where no sphere stands


def draw(layers):
    shown = [members[0] for members in by_bond(layers).values()]
    length = shown_length(shown)
    highest = max(1.0, *(layer.height.max() for layer in shown))
    figure, panels = rows_of_maps(len(shown), 1, shown[0], length)
    colours = pyplot.get_cmap(HEIGHTS).with_extremes(bad=EMPTY)
    for axes, layer in zip(panels[:, 0], shown):
        heights = numpy.where(layer.height > 0, layer.height, numpy.nan)[: round(length)]
        extent = (layer.x_range[0], layer.x_range[0] + length, 0, layer.width)
        image = axes.imshow(
            heights.T, origin="lower", extent=extent, vmin=0, vmax=highest, cmap=colours, interpolation="nearest"
        )
        frame(axes, layer, length)
        name_row(axes, bond_label(layer.bond))
    scale_bar(panels[0][0])
    bar = figure.colorbar(image, ax=panels[:, 0], location="bottom", shrink=0.8, aspect=30)
    bar.set_label(r"Highest point over the cell $z/d_p$ [–]; white: empty")
    return figure


if __name__ == "__main__":
    with logged(snakemake):
        layers = load_layers(snakemake)
        save(draw(layers), snakemake, layers)
