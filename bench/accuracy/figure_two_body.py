"""Two bodies: error against processor time, and against steps per contact."""

import numpy
from matplotlib.lines import Line2D

from workflow_scripts import read_json

from style import MARKERS, WIDTH, pyplot  # isort: skip

PAPER_RATIO = 0.001
PAPER_STEP = 2e-8
CONTACT_TIME = 4.471e-6  # of a pair at 0.05 m/s and the ratio of the paper [s; docs/physics.md section 4.1]
RESOLUTION = 0.02  # percent, to which capture velocity and pull-off load are found: smaller errors are drawn there
NAMES = {
    "discrete_gradient": "discrete gradient",
    "prediction_correction": "prediction-correction",
    "explicit_force": "explicit force",
}
CAPTURE = ["capture velocity, pair", "capture velocity, wall"]
COST = "processor s per ms and 1000 particles"


def percent(case, names, least=RESOLUTION):
    """Largest of the named errors at each step; beyond all bounds is not drawn."""
    found = []
    for row in case["steps"]:
        errors = [row["errors"][name]["worst"] for name in names]
        found.append(numpy.nan if None in errors else 100 * max(map(abs, errors)))
    return numpy.maximum(found, least)


def cost(case):
    """Processor seconds of a millisecond of a thousand particles at each step."""
    return numpy.array([row["processor_seconds"] for row in case["steps"]])


def dearer(case):
    """Whether each step costs more than some shorter one: where the solve of the pair takes a dearer branch."""
    seconds = cost(case)
    return numpy.concatenate([[False], seconds[1:] > numpy.minimum.accumulate(seconds)[:-1]])


def draw_line(axes, case, errors, number, label):
    """Errors over the cost of each step, hollow where a shorter step costs less."""
    seconds, hollow, color = cost(case), dearer(case), f"C{number}"
    axes.plot(seconds, errors, color=color, marker=MARKERS[number], label=label)
    axes.plot(seconds[hollow], errors[hollow], MARKERS[number], color=color, markerfacecolor="white", zorder=3)


def logarithmic(axes, title, ylabel, xlabel):
    """Common look of all panels."""
    axes.set(xscale="log", yscale="log", title=title, ylabel=ylabel, xlabel=xlabel)
    axes.axhline(1, color="0.7", linewidth=0.7, zorder=0)


def mark(axes, case, errors, step, marker):
    """A hollow sign around the point nearest to a time step."""
    nearest = min(range(len(errors)), key=lambda k: abs(case["steps"][k]["time_step"] / step - 1))
    axes.plot(cost(case)[nearest], errors[nearest], marker, markersize=9, markerfacecolor="none", color="black", zorder=4)


def by_scheme(axes, cases, bond, names, title, ylabel):
    """One line for each scheme at the ratio of the paper: a ring at the step of the paper, a square at the automatic."""
    for number, (scheme, label) in enumerate(NAMES.items()):
        case = next(c for c in cases if (c["bond"], c["ratio"], c["scheme"]) == (bond, PAPER_RATIO, scheme))
        errors = percent(case, names)
        draw_line(axes, case, errors, number, label)
        mark(axes, case, errors, PAPER_STEP, "o")
        if scheme == "discrete_gradient":
            mark(axes, case, errors, case["automatic_step"], "s")
    logarithmic(axes, title, ylabel, COST)


def by_ratio(axes, cases, bond):
    """One line for each stiffness ratio, over the steps in the contact time of that ratio."""
    own = sorted((c for c in cases if c["bond"] == bond and c["scheme"] == "discrete_gradient"), key=lambda c: c["ratio"])
    for number, case in enumerate(own):
        contact = CONTACT_TIME * (case["ratio"] / PAPER_RATIO) ** -0.4
        steps = [contact / row["time_step"] for row in case["steps"]]
        axes.plot(steps, percent(case, CAPTURE), marker=MARKERS[number], label=f"ratio {case['ratio']:g}")
    logarithmic(axes, f"Capture velocity, Bo = {bond:g}, any ratio", "worst error [%]", "steps per contact time at 0.05 m/s")
    axes.legend()


def by_bond(axes, cases):
    """Sliding to rest on the wall for each Bond number."""
    for number, bond in enumerate(sorted({case["bond"] for case in cases})):
        case = next(c for c in cases if (c["bond"], c["ratio"], c["scheme"]) == (bond, PAPER_RATIO, "discrete_gradient"))
        draw_line(axes, case, percent(case, ["stop distance"], least=1e-4), number, f"Bo = {bond:g}")
    logarithmic(axes, "Way of a sliding sphere to rest", "error [%]", COST)
    axes.legend()


def draw_key(axes):
    """What the signs beside those of the schemes mean."""
    sign = {"color": "black", "markerfacecolor": "none", "linestyle": ""}
    signs = {
        "the paper's step": Line2D([], [], marker="o", markersize=9, **sign),
        "the automatic step": Line2D([], [], marker="s", markersize=9, **sign),
        "dearer than a shorter": Line2D([], [], marker="o", color="C0", linestyle="", markerfacecolor="white"),
    }
    axes.legend(signs.values(), signs.keys(), loc="lower left")


def draw(cases, path):
    """Six panels: capture for three Bond numbers; pull-off; stiffness ratios; sliding."""
    figure, axes = pyplot.subplots(2, 3, figsize=(WIDTH * 2.5, WIDTH * 1.6))
    bonds = sorted({case["bond"] for case in cases})
    for panel, bond in zip(axes[0], bonds):
        by_scheme(panel, cases, bond, CAPTURE, f"Capture velocity, Bo = {bond:g}", "worst error [%]")
    by_scheme(axes[1][0], cases, bonds[1], ["pull-off force"], f"Pull-off force, Bo = {bonds[1]:g}", "error [%]")
    axes[0][0].legend()
    draw_key(axes[0][2])
    by_ratio(axes[1][1], cases, bonds[1])
    by_bond(axes[1][2], cases)
    figure.savefig(path, dpi=150, metadata={"Software": None})


if __name__ == "__main__":
    draw(read_json(snakemake.input[0])["two_body"], snakemake.output[0])
