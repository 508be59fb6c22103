"""What other choices cost and change: stiffness ratio, scheme, stages cut short, skins of the pair lists."""

import numpy
from matplotlib.ticker import NullLocator

from workflow_scripts import MARKERS, PAGE, pyplot, read_json

LAYER = ["median packing density", "roughness Ra [d_p]", "coordination number"]
BED = ["bed packing density", "bed coordination number"]


def relative(entry, base, name):
    """Distance from the base in percent, and its standard error."""
    own, other = entry["quantities"][name], base["quantities"][name]
    errors = [(part["standard_error"] or 0) / part["mean"] for part in (own, other)]
    return 100 * (own["mean"] / other["mean"] - 1), 100 * float(numpy.hypot(*errors))


def compare(axes, entries, base, names, labels, title):
    """One marker for each quantity and setting."""
    for number, name in enumerate(names):
        points = [relative(entry, base, name) for entry in entries]
        places = numpy.arange(len(entries)) + 0.12 * (number - (len(names) - 1) / 2)
        values, bars = zip(*points)
        axes.errorbar(places, values, bars, fmt=MARKERS[number], capsize=2, label=name)
    axes.axhline(0, color="0.6", linewidth=0.6)
    texts = [f"{label}\n{entry['processor_seconds']:.0f} s" for label, entry in zip(labels, entries)]
    axes.set_xticks(range(len(entries)), texts)
    axes.set(title=title, ylabel="difference [%]")
    axes.legend()


def ratios(axes, study, kind, bond, names):
    """Settings of the stiffness ratio study, from the stiffest."""
    entries = sorted(
        (e for e in study if (e["kind"], e["bond"]) == (kind, bond) and "quantities" in e), key=lambda e: -e["ratio"]
    )
    labels = [f"{entry['ratio']:g}" for entry in entries]
    compare(axes, entries, entries[0], names, labels, f"{kind}, Bo = {bond:g}, by stiffness ratio")


def named(axes, study, key, title):
    """Settings that have names; the default first."""
    first = {"scheme": "discrete_gradient", "shortcut": "none"}[key]
    entries = sorted((e for e in study if "quantities" in e), key=lambda e: e[key] != first)
    labels = [entry[key].replace("_", "\n") for entry in entries]
    compare(axes, entries, entries[0], LAYER, labels, title)


def skins(axes, study):
    """Processor time of a particle-step over each of the two looks ahead."""
    for number, (key, other, usual, scale) in enumerate(
        (("skin", "close_steps", 100, 0.1), ("close_steps", "skin", 0.1, 100))
    ):
        entries = sorted((e for e in study if e[other] == usual), key=lambda e: e[key])
        label = {"skin": "skin over 0.1 d_p", "close_steps": "steps of the close list over 100"}[key]
        axes.plot(
            [entry[key] / scale for entry in entries],
            [1e9 * entry["seconds_per_particle_step"] for entry in entries],
            marker=MARKERS[number],
            label=label,
        )
    axes.set(xscale="log", title="Pair lists", xlabel="over the default", ylabel="processor ns per particle-step")
    axes.set_xticks([0.25, 0.5, 1, 2, 4], ["1/4", "1/2", "1", "2", "4"])
    axes.xaxis.set_minor_locator(NullLocator())
    axes.set_ylim(bottom=0)
    axes.legend()


def draw(powder, path):
    """Six panels."""
    figure, axes = pyplot.subplots(2, 3, figsize=(PAGE * 1.25, PAGE * 0.8))
    study = powder["stiffness_ratio"]
    ratios(axes[0][0], study, "bed", 5.0, BED)
    ratios(axes[0][1], study, "bed", 50.0, BED)
    ratios(axes[0][2], study, "layer", 50.0, LAYER)
    named(axes[1][0], powder["scheme"], "scheme", "layer, Bo = 100, 1e-7 s, by scheme")
    named(axes[1][1], powder["shortcut"], "shortcut", "layer, Bo = 5, stages cut short")
    skins(axes[1][2], powder["skin"])
    figure.savefig(path, dpi=150, metadata={"Software": None})


if __name__ == "__main__":
    draw(read_json(snakemake.input[0])["powder"], snakemake.output[0])
