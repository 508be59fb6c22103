"""Conditions that a table of metrics can be held against: trends over the Bond number, bounds.

A verdict is "agrees", "differs" or "not testable": the last where the grid lacks the cases, or where the difference is
smaller than the uncertainty of the runs.
"""

import math
from dataclasses import dataclass
from itertools import pairwise

AGREES, DIFFERS, NOT_TESTABLE = "agrees", "differs", "not testable"


@dataclass
class Measured:
    """A value with its interval: of the bootstrap for one run, of the runs themselves for several seeds."""

    value: float
    lower: float
    upper: float


class Grid:
    """Metrics of the layers of one stiffness ratio, looked up by Bond number."""

    def __init__(self, table):
        self.table = table

    def bonds(self, lowest=0.0, highest=math.inf):
        """Bond numbers of the grid from lowest to highest, both included."""
        return sorted(bond for bond in self.table["bond_number"].unique() if lowest <= bond <= highest)

    def measured(self, name, bond):
        """A metric at one Bond number, or None where the grid has no such case."""
        rows = self.table[self.table["bond_number"] == bond]
        if rows.empty:
            return None
        values = rows[name]
        if len(rows) > 1:
            return Measured(values.mean(), values.min(), values.max())
        row = rows.iloc[0]
        return Measured(row[name], row[f"{name}_lower"], row[f"{name}_upper"])


def written(measured, scale=100, unit=" %"):
    """A measured value with its interval, as text."""
    if math.isnan(measured.value):
        return "undefined"
    text = f"{scale * measured.value:.3g}"
    if math.isfinite(measured.lower):
        text += f" [{scale * measured.lower:.3g}, {scale * measured.upper:.3g}]"
    return text + unit


def missing(bonds):
    """Result where the grid lacks Bond numbers."""
    return "no case at Bo = " + ", ".join(f"{bond:g}" for bond in bonds), NOT_TESTABLE


def step_sign(before, after):
    """1 or -1 where the change is larger than its uncertainty, 0 where it is not or a value is undefined.

    Intervals may be skew: of each only the side that faces the other value counts.
    """
    change = after.value - before.value
    if not math.isfinite(change):
        return 0
    low, high = (before, after) if change > 0 else (after, before)
    sides = [side if math.isfinite(side) else 0.0 for side in (low.upper - low.value, high.value - high.lower)]
    return 0 if abs(change) <= math.hypot(*sides) else int(math.copysign(1, change))


def trend(name, bonds, signs, scale=100, unit=" %"):
    """The metric rises (1) or falls (-1) from each Bond number to the next."""

    def evaluate(grid):
        values = [grid.measured(name, bond) for bond in bonds]
        absent = [bond for bond, value in zip(bonds, values) if value is None]
        if absent:
            return missing(absent)
        found = [step_sign(before, after) for before, after in pairwise(values)]
        text = "; ".join(f"Bo {bond:g}: {written(value, scale, unit)}" for bond, value in zip(bonds, values))
        if any(have == -want for have, want in zip(found, signs)):
            return text, DIFFERS
        return text, AGREES if all(have == want for have, want in zip(found, signs)) else NOT_TESTABLE

    return evaluate


def within(name, bonds, lower=-math.inf, upper=math.inf, scale=100, unit=" %"):
    """The metric lies between two bounds at every Bond number that is asked for and in the grid."""

    def evaluate(grid):
        chosen = bonds(grid)
        if not chosen:
            return "no such case", NOT_TESTABLE
        values = {bond: grid.measured(name, bond) for bond in chosen}
        text = "; ".join(f"Bo {bond:g}: {written(value, scale, unit)}" for bond, value in values.items())
        verdicts = [bounded(value, lower, upper) for value in values.values()]
        if DIFFERS in verdicts:
            return text, DIFFERS
        return text, NOT_TESTABLE if NOT_TESTABLE in verdicts else AGREES

    return evaluate


def bounded(measured, lower, upper):
    """Whether a value lies within bounds; outside, but with an interval that reaches them, is not testable."""
    if math.isnan(measured.value):
        return NOT_TESTABLE
    if lower <= measured.value <= upper:
        return AGREES
    reaches = math.isfinite(measured.lower) and measured.lower <= upper and measured.upper >= lower
    return NOT_TESTABLE if reaches else DIFFERS


def only(*bonds):
    """These Bond numbers, as far as the grid has them."""
    return lambda grid: [bond for bond in bonds if bond in grid.bonds()]


def between(lowest, highest=math.inf, above=False):
    """The grid's Bond numbers in a range; above leaves out the lowest itself."""
    return lambda grid: [bond for bond in grid.bonds(lowest, highest) if bond > lowest or not above]
