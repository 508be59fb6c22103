"""How a point of a run is drawn: with its time step in nanoseconds, and what is special about it."""

from matplotlib.ticker import LogLocator, NullFormatter
from statistics_of_runs import mean_by_seed, relative_difference

FAULT = "C3"


def time_axis(axes, label, marks=(1, 2, 5)):
    """A logarithmic axis of times in plain numbers, `marks` in each decade, with room beside the points."""
    axes.set_xscale("log")
    axes.margins(x=0.13, y=0.25)
    axes.xaxis.set_major_formatter("{x:g}")
    axes.xaxis.set_major_locator(LogLocator(subs=marks))
    axes.xaxis.set_minor_formatter(NullFormatter())
    axes.set_xlabel(label)


def nanoseconds(step):
    """A time step as it is written beside a point."""
    return f"{1e9 * step:g}"


def nearest_step(entries, step):
    """The one of the entries with the time step that is nearest in ratio."""
    return min(entries, key=lambda entry: max(entry["time_step"] / step, step / entry["time_step"]))


def from_reference(entry, reference, name):
    """Difference of a quantity from several settings taken together, over runs of the same seed, and its standard
    error, both in percent; None if there is no such run."""
    own = entry["quantities"][name]["by_seed"]
    found = relative_difference(own, mean_by_seed([part["quantities"][name] for part in reference]))
    return found and (100 * found["mean"], 100 * (found["standard_error"] or 0))


def label_steps(axes, entries, points, color="black"):
    """Writes the time step at the end of the bar of each (value, bar), every other one below it."""
    for number, k in enumerate(sorted(range(len(entries)), key=lambda k: entries[k]["processor_seconds"])):
        value, bar = points[k]
        sign = 1 if number % 2 == 0 else -1
        axes.annotate(
            nanoseconds(entries[k]["time_step"]),
            (entries[k]["processor_seconds"], value + sign * bar),
            (0, 7 * sign),
            textcoords="offset points",
            fontsize=6,
            color=color,
            ha="center",
            va="bottom" if sign > 0 else "top",
        )


def mark_faults(axes, entries, points):
    """A cross over each point of which not every run ended well."""
    for entry, (value, _) in zip(entries, points):
        if entry["faults"]:
            place = (entry["processor_seconds"], value)
            axes.plot(*place, "x", color=FAULT, markersize=9, markeredgewidth=1.5, zorder=4)


def say_faults(axes, entries, name=lambda entry: ""):
    """Below the points: which steps had runs that ended in a fault, and how many; one at which all did has no point.

    `name` gives what is to stand before the step.
    """
    faulted = [entry for entry in entries if entry["faults"]]
    lines = [f"{name(e)}{nanoseconds(e['time_step'])} ns: {e['faults']} of {e['runs']} runs faulted" for e in faulted]
    axes.text(0.98, 0.02, "\n".join(lines), transform=axes.transAxes, fontsize=6, color=FAULT, ha="right", va="bottom")
    bottom, top = axes.get_ylim()
    axes.set_ylim(bottom - 0.08 * len(lines) * (top - bottom), top)
