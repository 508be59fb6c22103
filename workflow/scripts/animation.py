"""A run as an animation from the side: particles coloured by their velocity along x."""

import io

import matplotlib
import numpy
from matplotlib.collections import EllipseCollection
from PIL import Image

from reporting import Implausible, logged
from states import read_state, times
from style import PAGE, pyplot

FRAMES = 120  # at most, evenly spread over the run
FRAME_TIME = 80  # [ms]
COLOURS = "coolwarm"
PIXELS_PER_INCH = 140


def chosen_steps(count):
    """Time steps that become frames; the first and the last are among them."""
    return numpy.unique(numpy.linspace(0, count - 1, min(count, FRAMES)).round().astype(int))


def frame(state, time, box, fastest):
    """One picture as RGB; box: x0, x1, z1 [d_p]; fastest: speed at the ends of the scale [m/s]."""
    left, right, top = box
    figure, axes = pyplot.subplots(figsize=(PAGE, 1.1 + PAGE * top / (right - left)), layout="constrained")
    points, diameter = state.points / state.diameter, 2 * state.radius / state.diameter
    order = numpy.argsort(-points[:, 1], kind="stable")  # the nearest on top
    disks = EllipseCollection(
        *2 * [diameter[order]],
        numpy.zeros(len(order)),
        units="xy",
        offsets=points[order][:, [0, 2]],
        offset_transform=axes.transData,
        cmap=COLOURS,
        norm=pyplot.Normalize(-fastest, fastest),
        edgecolors="black",
        linewidths=0.1,
    )
    disks.set_array(state.data["Velocity"][order, 0])
    axes.add_collection(disks)
    axes.axhline(0, color="black", linewidth=0.6)
    axes.set(xlim=(left, right), ylim=(-0.5, top), xlabel="$x/d_p$ [–]", ylabel="$z/d_p$ [–]", aspect="equal")
    axes.set_title(f"{1e3 * time:.1f} ms", loc="left")
    figure.colorbar(disks, ax=axes, location="bottom", shrink=0.5, aspect=40).set_label("velocity along x [m/s]")
    buffer = io.BytesIO()
    figure.savefig(buffer, dpi=PIXELS_PER_INCH, format="png")
    pyplot.close(figure)
    return Image.open(buffer).convert("RGB")


def animate(path, output):
    """Writes the trajectory of a run as a GIF."""
    matplotlib.use("Agg")
    moments = times(path)
    steps = chosen_steps(len(moments))
    states = [read_state(path, int(step)) for step in steps]
    places = numpy.concatenate([state.points[:, [0, 2]] / state.diameter for state in states])
    box = (places[:, 0].min() - 2, places[:, 0].max() + 2, places[:, 1].max() + 1)
    fastest = numpy.percentile(numpy.abs(numpy.concatenate([state.data["Velocity"][:, 0] for state in states])), 99)
    frames = [frame(state, moments[step], box, max(fastest, 1e-9)) for state, step in zip(states, steps)]
    palette = frames[-1].quantize(colors=128)
    first, *rest = [picture.quantize(palette=palette, dither=Image.Dither.NONE) for picture in frames]
    first.save(output, save_all=True, append_images=rest, duration=FRAME_TIME, loop=0, optimize=True)


if __name__ == "__main__":
    with logged(snakemake):
        trajectory = snakemake.params.trajectory
        if not trajectory.exists():
            raise Implausible(
                f"{trajectory} is not there: this run kept no states on the way; give output.trajectory_interval, such as 5 ms, "
                "in scene_overrides of the grid, and run the case again"
            )
        animate(trajectory, snakemake.output[0])
