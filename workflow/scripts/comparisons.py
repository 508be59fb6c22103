"""Further conditions that a table of metrics can be held against: several metrics, classes, slopes."""

import math
from itertools import pairwise

from measured import written
from verdicts import FAILS, HOLDS, UNKNOWN, Judgement, all_of, decided, difference, missing


def looked_up(grid, names, bonds):
    """Measured values by (name, Bond number), and the Bond numbers that the grid lacks."""
    values = {(name, bond): grid.measured(name, bond) for name in names for bond in bonds}
    return values, sorted({bond for (_, bond), value in values.items() if value is None})


def jointly(*conditions):
    """Several conditions, all of which have to hold."""

    def evaluate(grid):
        found = [condition(grid) for condition in conditions]
        bonds = tuple(sorted({bond for one in found for bond in one.bonds}))
        verdict, more = all_of([(one.verdict, one.more) for one in found])
        return Judgement("; ".join(dict.fromkeys(one.found for one in found)), verdict, more, bonds)

    return evaluate


def largest_at(name, bond, among, scale=100, unit=" %"):
    """The metric is larger at one Bond number than at each of the others among which it is sought."""

    def evaluate(grid):
        others = [other for other in among(grid) if other != bond]
        values, absent = looked_up(grid, [name], [bond, *others])
        if absent or not others:
            return missing(absent or [bond])
        text = "; ".join(f"Bo {at:g}: {written(values[name, at], scale, unit)}" for at in sorted([bond, *others]))
        parts = [difference(values[name, other], values[name, bond]) for other in others]
        return Judgement(text, *all_of(parts), (bond, *others))

    return evaluate


def lowest_at(name, bond, among, scale=1, unit=""):
    """The metric is lowest at this Bond number; the text names all at which it may be lowest, as far as intervals tell."""

    def evaluate(grid):
        values = {at: grid.measured(name, at) for at in among(grid)}
        values = {at: value for at, value in values.items() if math.isfinite(value.value)}
        if bond not in values or len(values) < 3:
            return Judgement(f"no case at Bo = {bond:g} and on both sides", UNKNOWN)
        best = min(values, key=lambda at: values[at].value)
        told = {at: difference(values[best], value) for at, value in values.items() if at != best}
        possible = sorted([best, *(at for at, (verdict, _) in told.items() if verdict == UNKNOWN)])
        text = f"lowest at Bo {best:g}, {written(values[best], scale, unit)}"
        if len(possible) > 1:
            text += "; may be so at " + ", ".join(f"Bo {at:g}" for at in possible)
        if bond not in possible:
            return Judgement(text, FAILS, 0.0, tuple(values))
        if len(possible) == 1:
            return Judgement(text, HOLDS, 0.0, tuple(values))
        return Judgement(text, UNKNOWN, max(told[at][1] for at in possible if at != best), tuple(possible))

    return evaluate


def larger_than(larger, smaller, bonds):
    """One metric is larger than another at every Bond number that is asked for."""

    def evaluate(grid):
        chosen = bonds(grid)
        if not chosen:
            return Judgement("no such case", UNKNOWN)
        values, _ = looked_up(grid, [larger, smaller], chosen)
        pairs = {bond: (values[smaller, bond], values[larger, bond]) for bond in chosen}
        text = "; ".join(f"Bo {bond:g}: {written(more)} against {written(less)}" for bond, (less, more) in pairs.items())
        return Judgement(text, *all_of([difference(*pair) for pair in pairs.values()]), tuple(chosen))

    return evaluate


def falls_with_class(name, bond, classes):
    """Shares NAME_0, NAME_1, ... at one Bond number fall from each to the next."""

    def evaluate(grid):
        names = [f"{name}_{number}" for number in range(classes)]
        values, absent = looked_up(grid, names, [bond])
        if absent:
            return missing(absent)
        text = "; ".join(f"{number}: {written(values[key, bond])}" for number, key in enumerate(names))
        parts = [difference(values[more, bond], values[fewer, bond]) for fewer, more in pairwise(names)]
        return Judgement(text, *all_of(parts), (bond,))

    return evaluate


def share_kept(name, first, last, share):
    """The metric at the last Bond number is at least this share of that at the first."""

    def evaluate(grid):
        values, absent = looked_up(grid, [name], [first, last])
        if absent:
            return missing(absent)
        before, after = values[name, first], values[name, last]
        room = after.value - share * before.value
        side = math.hypot(after.below(), share * before.above()) if room > 0 else math.hypot(after.above(), share * before.below())
        text = f"Bo {first:g}: {written(before, 1, '')}; Bo {last:g}: {written(after, 1, '')}"
        return Judgement(text, *decided(room, side), (first, last))

    return evaluate


def uncertainty(*values):
    """Half-width of a sum or difference of measured values, the wider sides of their intervals taken."""
    return math.hypot(*(max(value.below(), value.above()) for value in values))


def less_affected(small, large, bonds):
    """From one Bond number to the other, one share changes less than another."""

    def evaluate(grid):
        values, absent = looked_up(grid, [small, large], bonds)
        if absent:
            return missing(absent)
        less, more = (values[name, bonds[1]].value - values[name, bonds[0]].value for name in (small, large))
        text = f"change by {100 * less:+.2g} % and {100 * more:+.2g} % (± {100 * uncertainty(*values.values()):.2g} %)"
        return Judgement(text, *decided(abs(more) - abs(less), uncertainty(*values.values())), tuple(bonds))

    return evaluate


def varies_more(large, small, bonds):
    """Over the Bond numbers, one share ranges more widely than another."""

    def evaluate(grid):
        ends = {}
        for name in (large, small):
            found = [grid.measured(name, bond) for bond in bonds(grid)]
            known = [value for value in found if value and math.isfinite(value.value)]
            if len(known) < 2:
                return Judgement("fewer than two such cases", UNKNOWN)
            ends[name] = [choose(known, key=lambda value: value.value) for choose in (min, max)]
        ranges = [high.value - low.value for low, high in ends.values()]
        sure = uncertainty(*(value for pair in ends.values() for value in pair))
        text = f"ranges of {100 * ranges[0]:.2g} % and {100 * ranges[1]:.2g} % (± {100 * sure:.2g} %)"
        return Judgement(text, *decided(ranges[0] - ranges[1], sure), tuple(bonds(grid)))

    return evaluate


def slowing(name, bonds, unit=""):
    """The metric rises from the first of three Bond numbers to the second, and less steeply to the third."""

    def evaluate(grid):
        values, absent = looked_up(grid, [name], bonds)
        if absent:
            return missing(absent)
        first, second, third = (values[name, bond] for bond in bonds)
        spans = [after - before for before, after in pairwise(bonds)]
        slopes = [(second.value - first.value) / spans[0], (third.value - second.value) / spans[1]]
        weights = (1 / spans[0], 1 / spans[0] + 1 / spans[1], 1 / spans[1])
        sides = [weight * max(value.below(), value.above()) for weight, value in zip(weights, (first, second, third))]
        text = "; ".join(f"Bo {bond:g}: {written(values[name, bond], 1, unit)}" for bond in bonds)
        parts = [difference(first, second), decided(slopes[0] - slopes[1], math.hypot(*sides))]
        return Judgement(text, *all_of(parts), tuple(bonds))

    return evaluate


def linear(name, lowest, highest, tolerance, unit=""):
    """Between two Bond numbers the metric lies on a line, to within a share of its rise."""

    def evaluate(grid):
        inside = [bond for bond in grid.bonds(lowest, highest) if lowest < bond < highest]
        if not inside:
            return Judgement(f"no Bond number between {lowest:g} and {highest:g}: any two points lie on a line", UNKNOWN)
        values, absent = looked_up(grid, [name], [lowest, *inside, highest])
        if absent:
            return missing(absent)
        first, last = values[name, lowest], values[name, highest]
        parts = []
        for bond in inside:
            part = (bond - lowest) / (highest - lowest)
            off = values[name, bond].value - (1 - part) * first.value - part * last.value
            room = tolerance * abs(last.value - first.value) - abs(off)
            parts.append(decided(room, uncertainty(first, values[name, bond], last)))
        text = "; ".join(f"Bo {bond:g}: {written(values[name, bond], 1, unit)}" for bond in [lowest, *inside, highest])
        return Judgement(text, *all_of(parts), (lowest, *inside, highest))

    return evaluate
