"""What the largest of many in a layer of another area would be: the paper's extreme values belong to one large layer.

The sizes of the largest tenth, ten at least, are taken to lie beyond the size below them by exponentially distributed
excesses, and to be strewn at random over the layer. The interval is that of a prediction: it holds what chance does in
the other layer, and how little the few sizes tell about their scale and number.
"""

import math

import numpy

from measured import Measured, written
from verdicts import FAILS, HOLDS, UNKNOWN, Judgement, all_of, difference

PAPER_AREA = 390 * 40  # of the layer that the paper analyses [d_p^2]
FEWEST = 10
SHARE = 0.1
DRAWS = 20000


def prediction(sizes, area, other_area):
    """(lower, median, upper) of the largest size in a layer of `other_area`: 95 %; None where too few sizes are known.

    sizes: of all in layers of `area` together [d_p^2].
    """
    ordered = numpy.sort(numpy.asarray(sizes, dtype=float))[::-1]
    number = max(FEWEST, math.ceil(SHARE * len(ordered)))
    if len(ordered) <= number:
        return None
    threshold = ordered[number]
    scale = (ordered[:number] - threshold).mean()
    dice = numpy.random.default_rng(1)
    scales = scale * number / dice.gamma(number, size=DRAWS)
    beyond = dice.gamma(number, size=DRAWS) * other_area / area
    # The largest of a Poisson number of exponential excesses; below the threshold where there is none.
    largest = threshold + scales * numpy.log(beyond / dice.exponential(size=DRAWS))
    return tuple(numpy.percentile(largest, [2.5, 50, 97.5]))


def foreseen(grid, name, bond):
    """What all replicates together foresee of the largest of a layer of the paper's size, or None without a case."""
    rows = grid.table[grid.table["bond_number"] == bond]
    if rows.empty:
        return None
    return Measured(*(rows.iloc[0][f"{name}_{part}"] for part in ("paper", "paper_lower", "paper_upper")))


def largest_foreseen_at(name, bond, among, unit):
    """The largest of a layer of the paper's size is larger at one Bond number than at each of the others."""

    def evaluate(grid):
        others = [other for other in among(grid) if other != bond]
        values = {at: foreseen(grid, name, at) for at in sorted([bond, *others])}
        if not others or values[bond] is None:
            return Judgement(f"no case at Bo = {bond:g} and others", UNKNOWN)
        values = {at: value for at, value in values.items() if at == bond or math.isfinite(value.value)}
        text = "; ".join(f"Bo {at:g}: {written(value, 1, unit)}" for at, value in values.items())
        parts = [difference(value, values[bond]) for at, value in values.items() if at != bond]
        if not parts:
            return Judgement(f"{text}; too few pores at the others to extrapolate", UNKNOWN)
        return Judgement(text, *all_of(parts), tuple(values))

    return evaluate


def extreme(name, bond, printed, unit):
    """The paper's extreme value lies within what the grid predicts for a layer of that size."""

    def evaluate(grid):
        rows = grid.table[grid.table["bond_number"] == bond]
        if rows.empty:
            return Judgement(f"no case at Bo = {bond:g}", UNKNOWN)
        row = rows.iloc[0]
        found = ", ".join(f"{largest:.3g}" for largest in rows[name])
        text = f"{found}{unit} on {row['extremes_area']:.3g} d_p² in all"
        lower, middle, upper = (row[f"{name}_{part}"] for part in ("paper_lower", "paper", "paper_upper"))
        if not math.isfinite(middle):
            return Judgement(f"{text}: too few to extrapolate", UNKNOWN, math.inf, (bond,))
        text += f"; for 390 by 40 d_p {middle:.3g} [{lower:.3g}, {upper:.3g}]{unit}"
        return Judgement(text, HOLDS if lower <= printed <= upper else FAILS, 0.0, (bond,))

    return evaluate
