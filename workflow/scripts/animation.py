"""A run as an animation from the side: particles coloured by their velocity along x, walls and blade where they are."""

import io

import numpy
from matplotlib.collections import PolyCollection
from PIL import Image

from from_side import spheres
from reporting import Implausible, logged
from states import read_state, read_walls, times
from style import pyplot

FRAMES = 120  # at most, evenly spread over the run
FRAME_TIME = 80  # [ms]
COLOURS = "viridis"  # rises in grey as well
SIZE = 7.1  # width [inches]
PIXELS_PER_INCH = 140
WALL = "0.6"


def chosen_steps(count):
    """Time steps that become frames; the first and the last are among them."""
    return numpy.unique(numpy.linspace(0, count - 1, min(count, FRAMES)).round().astype(int))


def draw_walls(axes, walls, diameter):
    """Walls as seen along y; those that run across the view are lines."""
    shapes = [corners[:, [0, 2]] / diameter for _, corners in walls]
    axes.add_collection(PolyCollection(shapes, facecolors=WALL, edgecolors="black", linewidths=0.8))


def frame(state, walls, time, box, speeds):
    """One picture as RGB; box: x0, x1, z1 [d_p]; speeds: ends of the scale [m/s]."""
    left, right, top = box
    figure, axes = pyplot.subplots(figsize=(SIZE, 1.1 + SIZE * top / (right - left)))
    draw_walls(axes, walls, state.diameter)
    style = {"cmap": COLOURS, "norm": pyplot.Normalize(*speeds), "linewidths": 0.1}
    disks, order = spheres(axes, state, numpy.arange(len(state.points)), **style)
    disks.set_array(state.data["Velocity"][order, 0])
    axes.axhline(0, color="black", linewidth=0.8)
    axes.set(xlim=(left, right), ylim=(-0.5, top), xlabel="$x/d_p$ [–]", ylabel="$z/d_p$ [–]", aspect="equal")
    axes.set_title(f"{1e3 * time:.1f} ms", loc="left")
    bar = figure.colorbar(disks, ax=axes, location="bottom", shrink=0.5, aspect=40, extend="both")
    bar.set_label("Velocity along x [m/s]")
    buffer = io.BytesIO()
    figure.savefig(buffer, dpi=PIXELS_PER_INCH, format="png")
    pyplot.close(figure)
    return Image.open(buffer).convert("RGB")


def limits(states):
    """What all frames show (x0, x1, z1) [d_p] and the scale of their colours [m/s], without the fastest hundredths."""
    places = numpy.concatenate([state.points[:, [0, 2]] / state.diameter for state in states])
    speeds = numpy.concatenate([state.data["Velocity"][:, 0] for state in states])
    slowest, fastest = numpy.percentile(speeds, [1, 99])
    box = (places[:, 0].min() - 6, places[:, 0].max() + 2, places[:, 1].max() + 3)
    return box, (min(slowest, 0.0), max(fastest, slowest + 1e-9, 1e-9))


def animate(trajectory, walls, output):
    """Writes the states of a run, with walls and blade, as a GIF."""
    moments = times(trajectory)
    steps = chosen_steps(len(moments))
    states = [read_state(trajectory, int(step)) for step in steps]
    box, speeds = limits(states)
    pictures = [
        frame(state, read_walls(walls, moments[step]), moments[step], box, speeds)
        for state, step in zip(states, steps)
    ]
    palette = pictures[-1].quantize(colors=128)
    first, *rest = [picture.quantize(palette=palette, dither=Image.Dither.NONE) for picture in pictures]
    first.save(output, save_all=True, append_images=rest, duration=FRAME_TIME, loop=0, optimize=True)


if __name__ == "__main__":
    with logged(snakemake):
        folder = snakemake.params.run
        trajectory = folder / "trajectory.vtkhdf"
        if not trajectory.exists():
            raise Implausible(
                f"{trajectory} is not there: this run kept no states on the way; give output.trajectory_interval, such as 5 ms, "
                "in scene_overrides of the grid, and run the case again"
            )
        animate(trajectory, folder / "walls.vtkhdf", snakemake.output[0])
