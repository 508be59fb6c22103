"""Beds and layers: distance from the shorter steps against run time, with the scatter of replicates."""

from matplotlib.ticker import LogLocator, NullFormatter
from recommend import REFERENCE_STEP
from statistics_of_runs import pooled
from workflow_scripts import MARKERS, PAGE, pyplot, read_json

PANELS = [
    ("bed", "bed packing density"),
    ("bed", "bed coordination number"),
    ("layer", "median packing density"),
    ("layer", "roughness Ra [d_p]"),
    ("layer", "coordination number"),
    ("layer", "share of empty nodes"),
]


def draw_bond(axes, entries, name, number):
    """Means with their standard errors, in percent of the reference; returns the scatter of replicates in percent."""
    reference = pooled([entry for entry in entries if entry["time_step"] <= REFERENCE_STEP], name)
    if not reference or not reference["mean"]:
        return None
    rows = [entry for entry in entries if "quantities" in entry and entry["quantities"][name]["known"]]
    found = [entry["quantities"][name] for entry in rows]
    error = [100 * (part["mean"] / reference["mean"] - 1) for part in found]
    bars = [100 * (part["standard_error"] or 0) / reference["mean"] for part in found]
    axes.errorbar(
        [entry["processor_seconds"] for entry in rows],
        error,
        bars,
        marker=MARKERS[number],
        capsize=2,
        label=f"Bo = {entries[0]['bond']:g}",
        color=f"C{number}",
    )
    return 100 * reference["scatter"] / reference["mean"]


def panel(axes, study, kind, name):
    """One quantity at every Bond number."""
    bonds = sorted({entry["bond"] for entry in study if entry["kind"] == kind})
    for number, bond in enumerate(bonds):
        scatter = draw_bond(axes, [e for e in study if (e["kind"], e["bond"]) == (kind, bond)], name, number)
        if scatter is not None:
            axes.axhspan(-scatter, scatter, color=f"C{number}", alpha=0.10, linewidth=0)
    axes.axhline(0, color="0.6", linewidth=0.6)
    axes.set(xscale="log", title=name, xlabel="processor s per run", ylabel="from shorter steps [%]")
    axes.xaxis.set_major_formatter("{x:g}")
    axes.xaxis.set_major_locator(LogLocator(subs=(1, 2, 5)))
    axes.xaxis.set_minor_formatter(NullFormatter())
    axes.legend()


def draw(study, path):
    """Six panels; the bands are one scatter of replicates."""
    figure, axes = pyplot.subplots(2, 3, figsize=(PAGE * 1.25, PAGE * 0.75))
    for place, (kind, name) in zip(axes.flat, PANELS):
        panel(place, study, kind, name)
    figure.savefig(path, dpi=150, metadata={"Software": None})


if __name__ == "__main__":
    draw(read_json(snakemake.input[0])["powder"]["time_step"], snakemake.output[0])
