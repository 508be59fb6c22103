"""What other choices cost and change: stiffness ratio, scheme, precision, stages cut short, looks ahead of the pair lists."""

import numpy
from matplotlib.ticker import NullLocator
from recommend import PAPER_RATIO, SCHEME
from statistics_of_runs import relative_difference
from step_marks import label_steps, mark_faults, say_faults, time_axis
from workflow_scripts import read_json

from style import MARKERS, WIDTH, pyplot  # isort: skip

LAYER = ["median packing density", "roughness Ra [d_p]", "coordination number"]
BED = ["bed packing density", "bed coordination number"]
SCHEMES = [("bed", name) for name in BED] + [("layer", name) for name in LAYER]
SCHEME_NAMES = {
    "discrete_gradient": "discrete gradient",
    "prediction_correction": "prediction-correction",
    "explicit_force": "explicit force",
}
USUAL = {"skin": 0.1, "close_steps": 25}
LOOKS = {"skin": "skin over 0.1 d_p", "close_steps": "steps of the close list over 25"}


def relative(own, base):
    """Distance from the base in percent, and its standard error: over runs of the same seed. The base itself is 0."""
    if own is base:
        return 0.0, 0.0
    found = relative_difference(own["by_seed"], base["by_seed"])
    if found is None:
        return numpy.nan, 0.0
    return 100 * found["mean"], 100 * (found["standard_error"] or 0)


def room_above(axes, share):
    """Lets the scale go on above what is drawn, for the legend."""
    bottom, top = axes.get_ylim()
    axes.set_ylim(bottom, top + share * (top - bottom))


def compare(axes, entries, base, names, labels, title):
    """One marker for each quantity and setting, about the setting `base`, which is hollow."""
    others = [place for place, entry in enumerate(entries) if entry is not base]
    for number, name in enumerate(names):
        points = [relative(entry["quantities"][name], base["quantities"][name]) for entry in entries]
        places = numpy.arange(len(entries)) + 0.14 * (number - (len(names) - 1) / 2)
        values, bars = (numpy.array(column)[others] for column in zip(*points))
        look = {"color": f"C{number}", "label": name}
        axes.errorbar(places[others], values, bars, fmt=MARKERS[number], capsize=2, **look)
        axes.plot(places[entries.index(base)], 0, MARKERS[number], color=f"C{number}", markerfacecolor="white")
    axes.axhline(0, color="0.6", linewidth=0.6, zorder=0)
    texts = [f"{label}\n{e['runs']} runs\nof {e['processor_seconds']:.0f} s" for label, e in zip(labels, entries)]
    axes.set_xticks(range(len(entries)), texts)
    axes.set(title=title, ylabel="difference from hollow [%]")
    room_above(axes, 0.13 * len(names) + 0.05)
    axes.legend(loc="upper left", ncols=1)


def ratios(axes, study, kind, bond, names):
    """Settings of the stiffness ratio study from the stiffest, about that of the paper, which has the most replicates."""
    entries = [e for e in study if (e["kind"], e["bond"]) == (kind, bond) and "quantities" in e]
    entries.sort(key=lambda e: -e["ratio"])
    base = next(entry for entry in entries if entry["ratio"] == PAPER_RATIO)
    labels = [f"{entry['ratio']:g}" for entry in entries]
    compare(axes, entries, base, names, labels, f"{kind}, Bo = {bond:g}, by stiffness ratio")


def schemes(axes, study, kind, name):
    """Each scheme and step, about the shortest step of the default scheme."""
    entries = [entry for entry in study if entry["kind"] == kind and "quantities" in entry]
    usual = [entry for entry in entries if entry["scheme"] == SCHEME]
    base = min(usual, key=lambda entry: entry["time_step"])
    for number, (scheme, label) in enumerate(SCHEME_NAMES.items()):
        own = [entry for entry in entries if entry["scheme"] == scheme]
        if not own:
            continue
        points = [relative(entry["quantities"][name], base["quantities"][name]) for entry in own]
        seconds = [entry["processor_seconds"] for entry in own]
        values, bars = zip(*points)
        axes.errorbar(seconds, values, bars, fmt=MARKERS[number], color=f"C{number}", capsize=2, label=label)
        label_steps(axes, own, points, f"C{number}")
        mark_faults(axes, own, points)
    axes.plot(base["processor_seconds"], 0, "o", color="C0", markerfacecolor="white", zorder=4)
    axes.axhline(0, color="0.6", linewidth=0.6, zorder=0)
    axes.set(title=f"{kind}, Bo = {base['bond']:g}: {name}", ylabel="difference from hollow [%]")
    time_axis(axes, "processor s per run; numbers: step [ns]", (1, 1.5, 2, 3, 5, 7))
    say_faults(axes, [e for e in study if e["kind"] == kind], lambda e: f"{SCHEME_NAMES[e['scheme']]}, ")
    room_above(axes, 0.35)
    axes.legend(loc="upper left")


def shortcuts(axes, study, kind, names):
    """Stages that end early or late, about the usual."""
    entries = [entry for entry in study if entry["kind"] == kind and "quantities" in entry]
    entries.sort(key=lambda entry: entry["shortcut"] != "none")
    labels = ["usual" if e["shortcut"] == "none" else e["shortcut"].replace("_", "\n") for e in entries]
    compare(axes, entries, entries[0], names, labels, f"{kind}, Bo = {entries[0]['bond']:g}, ends of stages")


def precisions(axes, study, kind, bond, names):
    """Mixed precision about double."""
    entries = [e for e in study if (e["kind"], e["bond"]) == (kind, bond) and "quantities" in e]
    entries.sort(key=lambda entry: entry["precision"])
    labels = [entry["precision"] for entry in entries]
    compare(axes, entries, entries[0], names, labels, f"{kind}, Bo = {bond:g}, by precision")


def looks(axes, study, kind):
    """Processor time of a particle-step over each of the two looks ahead of the pair lists."""
    entries = [entry for entry in study if entry["kind"] == kind]
    base = next(e for e in entries if all(e[key] == usual for key, usual in USUAL.items()))
    for number, (key, label) in enumerate(LOOKS.items()):
        other = next(name for name in USUAL if name != key)
        own = [e for e in entries if e[other] == USUAL[other] and e is not base]
        cost = "seconds_per_particle_step"
        values, bars = zip(*(relative(entry["costs"][cost], base["costs"][cost]) for entry in own))
        places = numpy.array([entry[key] / USUAL[key] for entry in own]) * 1.04 ** (2 * number - 1)
        axes.errorbar(places, values, bars, fmt=MARKERS[number], color=f"C{number}", capsize=2, label=label)
    axes.plot(1, 0, "o", color="black", markerfacecolor="white")
    axes.axhline(0, color="0.6", linewidth=0.6, zorder=0)
    axes.set(xscale="log", title=f"{kind}, Bo = {base['bond']:g}: time of a particle-step")
    nanoseconds = 1e9 * base["seconds_per_particle_step"]
    axes.set_xlabel(f"over the default ({base['runs']} runs, {nanoseconds:.0f} ns)")
    axes.set_ylabel("difference from the default [%]")
    axes.set_xticks([0.5, 1, 2, 4], ["1/2", "1", "2", "4"])
    axes.xaxis.set_minor_locator(NullLocator())
    axes.margins(x=0.1)
    room_above(axes, 0.3)
    axes.legend(loc="upper left")


def panels(powder):
    """What each panel draws, in order."""
    study = powder["stiffness_ratio"]
    yield lambda axes: ratios(axes, study, "bed", 5.0, BED)
    yield lambda axes: ratios(axes, study, "bed", 50.0, BED)
    yield lambda axes: ratios(axes, study, "layer", 50.0, LAYER)
    for kind, name in SCHEMES:
        yield lambda axes, kind=kind, name=name: schemes(axes, powder["scheme"], kind, name)
    yield lambda axes: precisions(axes, powder["precision"], "bed", 50.0, BED)
    yield lambda axes: precisions(axes, powder["precision"], "bed", 400.0, BED)
    yield lambda axes: precisions(axes, powder["precision"], "layer", 100.0, LAYER)
    yield lambda axes: shortcuts(axes, powder["shortcut"], "bed", BED)
    yield lambda axes: shortcuts(axes, powder["shortcut"], "layer", LAYER)
    yield lambda axes: looks(axes, powder["skin"], "bed")
    yield lambda axes: looks(axes, powder["skin"], "layer")


def draw(powder, path):
    """Three panels in a row."""
    drawn = list(panels(powder))
    figure, axes = pyplot.subplots(len(drawn) // 3, 3, figsize=(WIDTH * 2.5, WIDTH * 0.28 * len(drawn)))
    for panel, draw_panel in zip(axes.flat, drawn, strict=True):
        draw_panel(panel)
    figure.savefig(path, dpi=150, metadata={"Software": None})


if __name__ == "__main__":
    draw(read_json(snakemake.input[0])["powder"], snakemake.output[0])
