"""Beds and layers: distance from the shorter steps against run time, with the scatter of replicates."""

from matplotlib.lines import Line2D
from matplotlib.patches import Patch
from recommend import ENERGY_LIMIT, REFERENCE_STEP
from statistics_of_runs import pooled
from step_marks import FAULT, from_reference, label_steps, mark_faults, nearest_step, say_faults, time_axis
from workflow_scripts import read_json

from style import MARKERS, WIDTH, pyplot  # isort: skip

ROWS = [
    ("bed", "bed packing density"),
    ("bed", "bed coordination number"),
    ("layer", "median packing density"),
    ("layer", "roughness Ra [d_p]"),
    ("layer", "coordination number"),
]
COLUMNS = 3


def draw_steps(axes, entries, name, automatic):
    """One quantity at one Bond number: a point for each step, about the mean of the steps up to REFERENCE_STEP."""
    usual = [e for e in entries if e["time_step"] <= REFERENCE_STEP and "quantities" in e]
    scatter = pooled(usual, name)
    axes.axhspan(*(sign * 100 * scatter["scatter"] / scatter["mean"] for sign in (-1, 1)), color="0.9", zorder=0)
    axes.axhline(0, color="0.6", linewidth=0.6, zorder=1)
    known = [e for e in entries if "quantities" in e and from_reference(e, usual, name)]
    points = [from_reference(entry, usual, name) for entry in known]
    for entry, (value, bar) in zip(known, points):
        fill = "white" if entry["time_step"] <= REFERENCE_STEP else "C0"
        axes.errorbar(entry["processor_seconds"], value, bar, fmt="o", color="C0", mfc=fill, capsize=2, zorder=3)
    chosen = nearest_step(known, automatic)
    place = chosen["processor_seconds"], points[known.index(chosen)][0]
    axes.plot(*place, "s", markersize=10, markerfacecolor="none", color="black")
    label_steps(axes, known, points)
    mark_faults(axes, known, points)
    time_axis(axes, "processor s per run")
    say_faults(axes, entries)


def draw_energy(axes, study, steps, kind):
    """Error of the balance of energy at each step, one line for each Bond number."""
    for number, bond in enumerate(sorted({e["bond"] for e in study if e["kind"] == kind})):
        entries = [e for e in study if (e["kind"], e["bond"]) == (kind, bond) and "quantities" in e]
        values = [100 * entry["energy_balance_error"] for entry in entries]
        times = [1e9 * entry["time_step"] for entry in entries]
        axes.plot(times, values, marker=MARKERS[number], label=f"Bo = {bond:g}")
        k = entries.index(nearest_step(entries, steps[kind, bond]))
        axes.plot(times[k], values[k], "s", markersize=10, markerfacecolor="none", color="black")
        for time, value, entry in zip(times, values, entries):
            if entry["faults"]:
                axes.plot(time, value, "x", color=FAULT, markersize=9, markeredgewidth=1.5)
    axes.axhline(100 * ENERGY_LIMIT, color="0.7", linewidth=0.7, zorder=0)
    axes.set(yscale="log", title=f"{kind}s: balance of energy", ylabel="worst error [%]")
    time_axis(axes, "time step [ns]")
    axes.legend()


def draw_key(axes):
    """What the signs of the other panels mean."""
    point = {"color": "C0", "marker": "o", "linestyle": ""}
    signs = [
        (Line2D([], [], **point), "mean and standard error; the number\nbeside it is the time step in ns"),
        (Line2D([], [], **point, markerfacecolor="white"), "one of the short steps that the\nothers are held to"),
        (Patch(color="0.9"), "one scatter of replicates"),
        (
            Line2D([], [], color="black", marker="s", linestyle="", markersize=9, markerfacecolor="none"),
            "nearest to the automatic step",
        ),
        (
            Line2D([], [], color=FAULT, marker="x", linestyle="", markersize=9, markeredgewidth=1.5),
            "some runs ended in a fault: the point\nis of the others",
        ),
    ]
    axes.axis("off")
    axes.legend(*zip(*signs), loc="center", labelspacing=1)


def draw(results, path):
    """A row for each quantity, a column for each Bond number; then the balance of energy."""
    study = results["powder"]["time_step"]
    steps = {(row["kind"], row["bond"]): row["automatic_step"] for row in results["recommended"]["powder"]}
    figure, axes = pyplot.subplots(len(ROWS) + 1, COLUMNS, figsize=(WIDTH * 2.5, WIDTH * 3.2))
    for row, (kind, name) in zip(axes, ROWS):
        bonds = sorted(bond for found, bond in steps if found == kind)
        for panel, bond in zip(row, bonds):
            entries = [e for e in study if (e["kind"], e["bond"]) == (kind, bond)]
            draw_steps(panel, entries, name, steps[kind, bond])
            panel.set_title(f"{name}, Bo = {bond:g}")
        row[0].set_ylabel("from short steps [%]")
    draw_energy(axes[-1][0], study, steps, "bed")
    draw_energy(axes[-1][1], study, steps, "layer")
    draw_key(axes[-1][2])
    figure.savefig(path, dpi=150, metadata={"Software": None})


if __name__ == "__main__":
    draw(read_json(snakemake.input[0]), snakemake.output[0])
