"""How far particles travel once the blade has released them, beside the inertial lengths [paper, section 5.5].

A particle is released where its centre passes behind the rear edge of the blade, between two states kept on the way
(straight line in between), and stops where it lies at the end. Collisions with others on that way count, which the
inertial lengths leave out. Of particles in the analysed region only.
"""

from pathlib import Path

import numpy
import yaml

from reporting import Implausible, logged, read_json, write_json
from states import length, read_state, times


def speed(quantity):
    """A speed of a resolved scene, such as "50 mm/s" [m/s]."""
    number, unit = str(quantity).split()
    factors = {"m/s": 1.0, "mm/s": 1e-3, "um/s": 1e-6, "cm/s": 1e-2}
    if unit not in factors:
        raise Implausible(f'"{quantity}" is not a speed: give a number and one of {", ".join(factors)}')
    return float(number) * factors[unit]


def begin_of_spread(summary):
    """Time at which the stage began [s]."""
    time = 0.0
    for stage in summary["stages"]:
        if stage["name"] == "spread":
            return time
        time += stage["time"]
    raise Implausible("the run has no stage spread")


def rear_edge(state, summary):
    """A function of time [s]: x of the rear edge of the blade [m]; it is lifted first and moves on at constant speed."""
    blade = yaml.safe_load(state.info["config"])["blade"]
    velocity = speed(blade["speed"])
    rise = length(blade["clearance"], state.diameter) - length(blade.get("height", "0 dp"), state.diameter)
    begin = begin_of_spread(summary) + rise / speed(blade.get("lift_speed", blade["speed"]))
    start, way = float(state.info["blade_start"]), float(state.info["spread_length"])
    return lambda time: start + numpy.clip((numpy.asarray(time) - begin) * velocity, 0, way)


def releases(frames, moments, edge):
    """x at which each particle was last passed by the edge [m]; not a number for those that it never passed.

    frames: centres along x of every state, [states, particles], particles in the same order.
    """
    ahead = frames - edge(moments)[:, None]
    passed = (ahead[:-1] >= 0) & (ahead[1:] < 0)
    last = len(passed) - 1 - numpy.argmax(passed[::-1], axis=0)
    particles = numpy.arange(frames.shape[1])
    before, after = ahead[last, particles], ahead[last + 1, particles]
    with numpy.errstate(invalid="ignore", divide="ignore"):
        part = before / (before - after)
        place = (1 - part) * frames[last, particles] + part * frames[last + 1, particles]
    return numpy.where(passed.any(axis=0), place, numpy.nan)


def measured(path, final, summary, region):
    """Distances from release to rest [d_p] of the particles that lie in the region at the end."""
    moments, states = times(path), []
    for step in range(len(moments)):
        state = read_state(path, step)
        states.append(state.points[numpy.argsort(state.data["Id"]), 0])
    end = final.points[numpy.argsort(final.data["Id"]), 0]
    frames = numpy.array([*states, end])
    moments = numpy.append(moments, sum(stage["time"] for stage in summary["stages"]))
    place = releases(frames, moments, rear_edge(final, summary))
    counted = numpy.isfinite(place) & (end >= region[0]) & (end < region[1])
    return (end - place)[counted] / final.diameter


def summarised(distances, lengths, states):
    """Quartiles, 95th percentile and mean of the distances beside the inertial lengths [d_p]."""
    if not len(distances):
        raise Implausible("no particle of the analysed region was seen on both sides of the blade's rear edge")
    names = ("lower_quartile", "median", "upper_quartile", "largest_twentieth")
    found = dict(zip(names, numpy.percentile(distances, [25, 50, 75, 95]).tolist()))
    return {"particles": len(distances), "states": states, **found, "mean": float(distances.mean()), "inertial_length": lengths}


if __name__ == "__main__":
    with logged(snakemake):
        inputs, path = snakemake.input, snakemake.params.trajectory
        if not Path(path).exists():
            raise Implausible(f"{path}: this run kept no states on the way; give output.trajectory_interval, such as 1 ms")
        summary, region = read_json(inputs.summary), read_json(inputs.region)["x_range"]
        distances = measured(path, read_state(inputs.state), summary, region)
        lengths = read_json(inputs.derived)["inertial_length"]
        write_json(snakemake.output[0], summarised(distances, lengths, len(times(path))))
