"""Conditions that a table of metrics can be held against: trends over the Bond number, bounds.

A statement holds, does not hold, or cannot be told: where the grid lacks the cases, or where the interval of 95 % reaches
over the mark that decides. Then the judgement says how much more layer would decide it if the value stayed as it is,
for intervals narrow with the root of the layer's area, or of the number of layers.
"""

import math
from dataclasses import dataclass
from itertools import pairwise

from measured import written

HOLDS, FAILS, UNKNOWN = "holds", "does not hold", "cannot be told"
RISE, FALL = 1, -1


@dataclass(frozen=True)
class Judgement:
    """What was found, the verdict, and where it cannot be told how many times the layers of `bonds` it would take:
    infinite where no difference is seen at all, 0 where no size of layer tells (see `found`)."""

    found: str
    verdict: str
    more: float = 0.0
    bonds: tuple = ()


def missing(bonds):
    """Judgement where the grid lacks Bond numbers."""
    return Judgement("no case at Bo = " + ", ".join(f"{bond:g}" for bond in bonds), UNKNOWN)


def decided(distance, side):
    """Verdict on a number that has to be positive and is known to +- side, and how much more layer would tell."""
    if not math.isfinite(distance):
        return UNKNOWN, 0.0
    if distance > side or (side == 0 and distance >= 0):
        return HOLDS, 0.0
    if distance < -side:
        return FAILS, 0.0
    return UNKNOWN, (side / distance) ** 2 if distance else math.inf


def all_of(parts):
    """Verdict on several parts (verdict, more), all of which have to hold; and what the worst of the unknown takes."""
    verdicts = [verdict for verdict, _ in parts]
    if FAILS in verdicts:
        return FAILS, 0.0
    if UNKNOWN in verdicts:
        return UNKNOWN, max(more for verdict, more in parts if verdict == UNKNOWN)
    return HOLDS, 0.0


def difference(smaller, larger):
    """Whether one value is below the other.

    Intervals may be skew: of each only the side that faces the other value counts.
    """
    change = larger.value - smaller.value
    sides = (smaller.above(), larger.below()) if change > 0 else (smaller.below(), larger.above())
    return decided(change, math.hypot(*sides))


def trend(name, bonds, signs, scale=100, unit=" %"):
    """The metric rises (1) or falls (-1) from each Bond number to the next."""

    def evaluate(grid):
        values = [grid.measured(name, bond) for bond in bonds]
        absent = [bond for bond, value in zip(bonds, values) if value is None]
        if absent:
            return missing(absent)
        parts = [
            difference(before, after) if sign > 0 else difference(after, before)
            for (before, after), sign in zip(pairwise(values), signs)
        ]
        text = "; ".join(f"Bo {bond:g}: {written(value, scale, unit)}" for bond, value in zip(bonds, values))
        return Judgement(text, *all_of(parts), tuple(bonds))

    return evaluate


def within(name, bonds, lower=-math.inf, upper=math.inf, scale=100, unit=" %", extreme=False):
    """The metric lies between two bounds at every Bond number that is asked for and in the grid; of an `extreme` value
    the largest of the replicates."""

    def evaluate(grid):
        chosen = bonds(grid)
        if not chosen:
            return Judgement("no such case", UNKNOWN)
        values = {bond: grid.measured(name, bond) for bond in chosen}
        text = "; ".join(f"Bo {bond:g}: {written(value, scale, unit)}" for bond, value in values.items())
        parts = [exceeded(value, lower, upper) if extreme else bounded(value, lower, upper) for value in values.values()]
        return Judgement(text, *all_of(parts), tuple(chosen))

    return evaluate


def bounded(measured, lower, upper):
    """Whether a value lies within bounds, as far as its interval tells: (verdict, more)."""
    return all_of([decided(measured.value - lower, measured.below()) if lower > -math.inf else (HOLDS, 0.0),
                   decided(upper - measured.value, measured.above()) if upper < math.inf else (HOLDS, 0.0)])


def exceeded(measured, lower, upper):
    """The same of an extreme value: one that lies beyond the bound decides, whatever the others."""
    if math.isnan(measured.value):
        return UNKNOWN, 0.0
    return (HOLDS if lower <= measured.largest <= upper else FAILS), 0.0


def only(*bonds):
    """These Bond numbers, as far as the grid has them."""
    return lambda grid: [bond for bond in bonds if bond in grid.bonds()]


def between(lowest, highest=math.inf, above=False):
    """The grid's Bond numbers in a range; above leaves out the lowest itself."""
    return lambda grid: [bond for bond in grid.bonds(lowest, highest) if bond > lowest or not above]
