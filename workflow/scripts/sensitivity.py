"""What single choices change in the layers: each metric of a variation beside that of the grid's own layers.

Replicates of all variations together tell how much wider than the bootstrap the intervals have to be.
"""

import math

import numpy
import pandas

from layer_metrics import scalars
from layers import load_layers
from measured import Grid, written
from reporting import logged, write_text
from style import pyplot
from verdicts import UNKNOWN, difference

# Metric -> what it is called, factor, unit.
SHOWN = {
    "packing_median": ("median packing density", 1, ""),
    "packing_iqr_over_median": ("IQR / median", 1, ""),
    "particles_per_area": ("particles", 1, " per d_p²"),
    "roughness_dp": ("roughness", 1, " d_p"),
    "empty_area": ("empty nodes", 100, " %"),
    "coordination_0": ("without contact", 100, " %"),
    "cluster_mean": ("mean cluster", 1, " particles"),
}
BASE = "layers"


def measurements(kinds, layers):
    """One row per layer: kind, Bond number and the metrics shown with their intervals."""
    rows = []
    for kind, layer in zip(kinds, layers, strict=True):
        row = {"kind": kind, "bond": layer.bond}
        found = scalars(layer)
        for name in SHOWN:
            row |= dict(zip((name, f"{name}_lower", f"{name}_upper"), found[name]))
        rows.append(row)
    return pandas.DataFrame(rows)


def compared(rows, titles):
    """One row per variation, Bond number and metric: both values, their difference, and whether one is seen."""
    groups = {key: number for number, key in enumerate(dict.fromkeys(zip(rows["kind"], rows["bond"])))}
    # Every pair of kind and Bond number is a group of its own, so that all replicates tell the scatter together.
    grid = Grid(rows.assign(bond_number=[groups[key] for key in zip(rows["kind"], rows["bond"])]))
    found = []
    for (kind, bond), number in groups.items():
        if kind == BASE:
            continue
        for name, (label, scale, unit) in SHOWN.items():
            base, value = (grid.measured(name, key) for key in (groups[BASE, bond], number))
            side = math.hypot(max(base.below(), base.above()), max(value.below(), value.above()))
            found.append(
                {
                    "variation": titles[kind],
                    "bond_number": bond,
                    "metric": name,
                    "default": base.value,
                    "varied": value.value,
                    "difference": value.value - base.value,
                    "uncertainty": side,
                    "seen": difference(base, value)[0] != UNKNOWN,
                    "text": f"{label} {written(base, scale, unit)} → {written(value, scale, unit)}",
                }
            )
    return pandas.DataFrame(found)


def paragraphs(table, layers):
    """A plain paragraph for each variation, in Markdown."""
    chance = 0.05 * len(table)
    texts = [
        f"From {layers} layers; intervals of 95 %, replicates in brackets. Of {len(table)} comparisons {int(table['seen'].sum())} "
        f"show a difference; {chance:.0f} would by chance if nothing mattered.\n"
    ]
    for title, rows in table.groupby("variation", sort=False):
        sentences = []
        for bond, mine in rows.groupby("bond_number"):
            seen = mine[mine["seen"]]
            what = "; ".join(seen["text"]) if len(seen) else "no difference beyond the scatter"
            sentences.append(f"Bo = {bond:g}: {what}.")
        texts.append(f"**{title[0].upper()}{title[1:]}.** {' '.join(sentences)}\n")
    return "\n".join(texts)


def draw(table):
    """Difference to the default of every variation and metric in units of its value there, a panel per Bond number."""
    bonds, titles = sorted(table["bond_number"].unique()), list(dict.fromkeys(table["variation"]))
    figure, panels = pyplot.subplots(
        len(SHOWN), len(bonds), figsize=(7.1, 0.6 + len(SHOWN) * (0.35 + 0.13 * len(titles))), sharey=True, squeeze=False
    )
    for line, (name, (label, _, _)) in enumerate(SHOWN.items()):
        for axes, bond in zip(panels[line], bonds):
            rows = table[(table["metric"] == name) & (table["bond_number"] == bond)].set_index("variation").loc[titles]
            base = rows["default"].abs()
            change, side = (100 * (rows[key] / base).to_numpy() for key in ("difference", "uncertainty"))
            place = numpy.arange(len(titles))
            axes.axvline(0, color="0.6", linewidth=0.6)
            axes.hlines(place, change - side, change + side, color="black", linewidth=0.8)
            axes.scatter(change, place, 14, c=["black" if seen else "white" for seen in rows["seen"]], edgecolors="black", zorder=3)
            axes.set_title(f"{label}, Bo = {bond:g}", loc="left", fontsize=7)
            axes.set_yticks(place, titles, fontsize=6)
        panels[line][0].invert_yaxis()  # shared by the row
    for axes in panels[-1]:
        axes.set_xlabel("change [%]")
    return figure


if __name__ == "__main__":
    with logged(snakemake):
        layers = load_layers(snakemake)
        table = compared(measurements(snakemake.params.kinds, layers), dict(snakemake.params.titles))
        write_text(snakemake.output.table, table.drop(columns="text").to_csv(index=False, float_format="%.6g"))
        write_text(snakemake.output.text, paragraphs(table, len(layers)))
        figure = draw(table)
        figure.savefig(snakemake.output.vector, metadata={"CreationDate": None})
        figure.savefig(snakemake.output.bitmap, metadata={"Software": None})
