"""Two bodies: error against processor time, and against steps per contact."""

import numpy

from workflow_scripts import MARKERS, PAGE, pyplot, read_json

PAPER_RATIO = 0.001
PAPER_STEP = 2e-8
CONTACT_TIME = 4.471e-6  # of a pair at 0.05 m/s and the ratio of the paper [s; docs/physics.md section 4.1]
NAMES = {
    "discrete_gradient": "discrete gradient",
    "prediction_correction": "prediction-correction",
    "explicit_force": "explicit force",
}


def percent(case, names, part="worst"):
    """Largest of the named errors at each step; beyond all bounds is not drawn."""
    found = []
    for row in case["steps"]:
        errors = [row["errors"][name][part] for name in names]
        found.append(numpy.nan if None in errors else 100 * max(map(abs, errors)))
    return numpy.maximum(found, 1e-3)


def cost(case):
    """Processor seconds of a millisecond of a thousand particles at each step."""
    return [row["processor_seconds"] for row in case["steps"]]


def logarithmic(axes, title, ylabel):
    """Common look of all panels."""
    axes.set(xscale="log", yscale="log", title=title, ylabel=ylabel)
    axes.axhline(1, color="0.7", linewidth=0.7, zorder=0)


def mark(axes, case, errors, step, marker):
    """A hollow sign around the point nearest to a time step."""
    nearest = min(range(len(errors)), key=lambda k: abs(case["steps"][k]["time_step"] / step - 1))
    axes.plot(cost(case)[nearest], errors[nearest], marker, markersize=9, markerfacecolor="none", color="black")


def by_scheme(axes, cases, bond, names, title):
    """One line for each scheme at the ratio of the paper: a ring at the step of the paper, a square at the automatic."""
    for number, (scheme, label) in enumerate(NAMES.items()):
        case = next(c for c in cases if (c["bond"], c["ratio"], c["scheme"]) == (bond, PAPER_RATIO, scheme))
        errors = percent(case, names)
        axes.plot(cost(case), errors, marker=MARKERS[number], label=label)
        mark(axes, case, errors, PAPER_STEP, "o")
        if scheme == "discrete_gradient":
            mark(axes, case, errors, case["automatic_step"], "s")
    logarithmic(axes, title, "worst error [%]")
    axes.set_xlabel("processor s per ms and 1000 particles")


def by_ratio(axes, cases, bond):
    """One line for each stiffness ratio, over the steps in the contact time of that ratio."""
    own = sorted((c for c in cases if c["bond"] == bond and c["scheme"] == "discrete_gradient"), key=lambda c: c["ratio"])
    for number, case in enumerate(own):
        contact = CONTACT_TIME * (case["ratio"] / PAPER_RATIO) ** -0.4
        steps = [contact / row["time_step"] for row in case["steps"]]
        errors = percent(case, ["capture velocity, pair", "capture velocity, wall"])
        axes.plot(steps, errors, marker=MARKERS[number], label=f"ratio {case['ratio']:g}")
    logarithmic(axes, f"Capture velocity, Bo = {bond:g}, any ratio", "worst error [%]")
    axes.set_xlabel("steps per contact time at 0.05 m/s")


def by_bond(axes, cases):
    """Sliding to rest on the wall for each Bond number."""
    for number, bond in enumerate(sorted({case["bond"] for case in cases})):
        case = next(c for c in cases if (c["bond"], c["ratio"], c["scheme"]) == (bond, PAPER_RATIO, "discrete_gradient"))
        axes.plot(cost(case), percent(case, ["stop distance"]), marker=MARKERS[number], label=f"Bo = {bond:g}")
    logarithmic(axes, "Way of a sliding sphere to rest", "error [%]")
    axes.set_xlabel("processor s per ms and 1000 particles")


def draw(cases, path):
    """Six panels: capture for three Bond numbers; pull-off; stiffness ratios; sliding."""
    figure, axes = pyplot.subplots(2, 3, figsize=(PAGE * 1.25, PAGE * 0.8))
    bonds = sorted({case["bond"] for case in cases})
    capture = ["capture velocity, pair", "capture velocity, wall"]
    for panel, bond in zip(axes[0], bonds):
        by_scheme(panel, cases, bond, capture, f"Capture velocity, Bo = {bond:g}")
    by_scheme(axes[1][0], cases, bonds[1], ["pull-off force"], f"Pull-off force, Bo = {bonds[1]:g}")
    by_ratio(axes[1][1], cases, bonds[1])
    by_bond(axes[1][2], cases)
    for panel in axes.flat:
        panel.legend()
    figure.savefig(path, dpi=150, metadata={"Software": None})


if __name__ == "__main__":
    draw(read_json(snakemake.input[0])["two_body"], snakemake.output[0])
