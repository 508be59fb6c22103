"""What a table of metrics says of a quantity at one Bond number: its value over the replicates, and an interval."""

import math
from dataclasses import dataclass
from functools import cache

import numpy
from scipy.stats import t as student

CONFIDENCE = 0.95
NORMAL = 1.959964  # half-width of an interval of that confidence over the standard error, for many degrees of freedom


@dataclass(frozen=True)
class Measured:
    """Mean over the runs with the interval of that mean; `runs` are the values of the replicates."""

    value: float
    lower: float
    upper: float
    runs: tuple = ()

    @property
    def largest(self):
        """Over the replicates: what an extreme value is held against."""
        return max(self.runs, default=self.value)

    def below(self):
        """Side of the interval below the value; 0 where there is no interval."""
        return self.value - self.lower if math.isfinite(self.lower) else 0.0

    def above(self):
        """Side of the interval above the value."""
        return self.upper - self.value if math.isfinite(self.upper) else 0.0


class Grid:
    """Metrics of the layers of one stiffness ratio, looked up by Bond number.

    Every run has an interval by the block bootstrap, which tells the scatter between places of one layer. Whether that
    is all of the scatter between runs, replicates tell: where they scatter more than their bootstrap intervals say, by
    a factor that all Bond numbers of the table share, all intervals of that metric are as much wider.
    """

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
        values = rows[name].to_numpy(dtype=float)
        known = numpy.isfinite(values)
        if not known.any():
            return Measured(math.nan, math.nan, math.nan)
        values = values[known]
        lower, upper = (rows[f"{name}_{side}"].to_numpy(dtype=float)[known] for side in ("lower", "upper"))
        mean = values.mean()
        if not numpy.isfinite([lower, upper]).all():
            half = self.replicates_alone(name, values)
            return Measured(mean, mean - half, mean + half, tuple(values))
        widening = self.widening(name) / len(values)
        sides = (math.hypot(*(values - lower)), math.hypot(*(upper - values)))
        return Measured(mean, mean - widening * sides[0], mean + widening * sides[1], tuple(values))

    def replicates_alone(self, name, values):
        """Half-width of the interval of a mean without bootstrap: by the scatter of all replicates of the metric."""
        squares, freedom = self.scatter(name)[:2]
        if freedom == 0:
            return math.nan
        return student.ppf(0.5 + 0.5 * CONFIDENCE, freedom) * math.sqrt(squares / freedom / len(values))

    def widening(self, name):
        """By how much replicates scatter more than their bootstrap intervals say; at least 1, and 1 without replicates.

        For few replicates Student's distribution makes up for how little they tell.
        """
        squares, freedom, expected = self.scatter(name)
        if freedom == 0 or not expected > 0:
            return 1.0
        return max(1.0, math.sqrt(squares / expected) * student.ppf(0.5 + 0.5 * CONFIDENCE, freedom) / NORMAL)

    @cache
    def scatter(self, name):
        """Of replicates about the means of their Bond numbers: sum of squares, degrees of freedom, and what that sum
        would be by the bootstrap."""
        squares = expected = 0.0
        freedom = 0
        for _, rows in self.table.groupby("bond_number"):
            values = rows[name].to_numpy(dtype=float)
            widths = (rows[f"{name}_upper"] - rows[f"{name}_lower"]).to_numpy(dtype=float)
            known = numpy.isfinite(values)
            more = known.sum() - 1
            if more < 1:
                continue
            freedom += int(more)
            squares += ((values[known] - values[known].mean()) ** 2).sum()
            expected += more * numpy.nanmean((widths[known] / (2 * NORMAL)) ** 2) if numpy.isfinite(widths[known]).any() else 0.0
        return float(squares), freedom, float(expected)


def written(measured, scale=100, unit=" %"):
    """A measured value with its interval and the replicates behind it, as text."""
    if math.isnan(measured.value):
        return "undefined"
    text = f"{scale * measured.value:.3g}"
    if math.isfinite(measured.lower):
        text += f" [{scale * measured.lower:.3g}, {scale * measured.upper:.3g}]"
    text += unit
    if len(measured.runs) > 1:
        text += f" (runs: {', '.join(f'{scale * run:.3g}' for run in measured.runs)})"
    return text
