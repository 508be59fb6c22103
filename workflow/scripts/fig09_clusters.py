"""Figure 9: clusters in the layer, coloured by their angle to the spreading direction."""

import numpy
from matplotlib.patches import Patch

from from_above import centres, disks, frame, name_row, rows_of_maps, shown_length
from layers import by_bond, load_layers
from reporting import logged
from style import bond_label, pyplot, save, scale_bar

ANGLES = "viridis"
NO_ANGLE = "0.75"  # round the period, or without a direction that stands out


def draw_clusters(axes, layer, extent):
    """Particles that touch others; single ones are left out."""
    x, y = centres(layer)
    clustered = (x >= extent[0] - 1) & (x < extent[1] + 1) & (layer.cluster_size > 1)
    angle = layer.cluster_angle
    diameters = 2 * layer.state.radius / layer.diameter
    style = {"edgecolors": "black", "linewidths": 0.15}
    plain = clustered & ~numpy.isfinite(angle)
    disks(axes, x[plain], y[plain], diameters[plain], facecolors=NO_ANGLE, **style)
    turned = clustered & numpy.isfinite(angle)
    drawn = disks(axes, x[turned], y[turned], diameters[turned], cmap=ANGLES, norm=pyplot.Normalize(0, 90), **style)
    drawn.set_array(numpy.tile(angle[turned], 3))
    return drawn


def draw(layers):
    shown = [members[0] for members in by_bond(layers).values()]
    length = shown_length(shown)
    rows = (len(shown) + 1) // 2
    columns = min(2, len(shown))
    uneven = rows * columns - len(shown)
    figure, panels = rows_of_maps(rows, columns, shown[0], length, above=0.25 + 0.35 * uneven)
    places = panels.T.ravel()  # down the left column first, as Bond numbers rise
    for axes in places[len(shown) :]:
        axes.set_axis_off()
    for axes, letter, layer in zip(places, "abcdefghijkl", shown):
        extent = frame(axes, layer, length)
        drawn = draw_clusters(axes, layer, extent)
        name_row(axes, f"({letter}) {bond_label(layer.bond)}")
    for axes in places[[len(shown) - 1]]:  # in the last column nothing may be below it
        axes.tick_params(labelbottom=True)
        axes.set_xlabel("$x/d_p$", labelpad=1)
    scale_bar(places[0])
    bar = figure.colorbar(drawn, ax=panels, location="bottom", shrink=0.7, aspect=30, ticks=range(0, 91, 15))
    bar.set_label("Angle of the cluster to the spreading direction [°]")
    patch = Patch(facecolor=NO_ANGLE, edgecolor="black", label="cluster without direction, or round the period")
    figure.legend(handles=[patch], loc="outside upper center")
    return figure


if __name__ == "__main__":
    with logged(snakemake):
        layers = load_layers(snakemake)
        save(draw(layers), snakemake, layers, "One seed of each Bond number is shown.")
