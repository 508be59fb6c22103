"""The table of docs/verification.md: quantities of both codes with their scatter between seeds."""

from math import sqrt
from statistics import mean, stdev

BEGIN, END = "<!-- table of make cross-code -->", "<!-- end of table of make cross-code -->"
QUANTITIES = {"density": ("packing density", 4), "coordination_number": ("coordination number", 3)}


def compare(first, second):
    """Means, standard deviations between seeds, and the difference of the means over its standard error.

    The starts are the same, but collisions soon make runs independent of each other: no pairs.
    """
    error = sqrt((stdev(first) ** 2 + stdev(second) ** 2) / len(first))
    return {
        "means": [mean(first), mean(second)],
        "deviations": [stdev(first), stdev(second)],
        "errors_apart": abs(mean(first) - mean(second)) / error if error > 0 else 0.0,
    }


def table(results):
    """Markdown of bench/results/cross_code.json."""
    lines = ["| case | quantity | recoat | LAMMPS | difference over its standard error |", "|---|---|---|---|---|"]
    for case, codes in results["cases"].items():
        for key, (name, digits) in QUANTITIES.items():
            found = compare([run[key] for run in codes["recoat"]], [run[key] for run in codes["lammps"]])
            cells = [f"{m:.{digits}f} ± {s:.{digits}f}" for m, s in zip(found["means"], found["deviations"])]
            lines.append(f"| {case} | {name} | {cells[0]} | {cells[1]} | {found['errors_apart']:.1f} |")
    return "\n".join(lines)


def put_into(text, results):
    """A document with its table made anew."""
    before, rest = text.split(BEGIN)
    return f"{before}{BEGIN}\n\n{table(results)}\n\n{END}{rest.split(END)[1]}"
