"""Intervals of what figures show: the same as those of the verdicts, replicates first, bootstrap second."""

import numpy
import pandas

from measured import Grid


def over_replicates(groups, statistic):
    """Mean over the runs of each group and its 95 % interval: key -> (value, lower, upper), arrays or single numbers.

    `groups`: key -> layers; `statistic`: layer -> (value, lower, upper) with the bootstrap interval of that layer.
    With one run in each group this is what the bootstrap says; measured.Grid tells what becomes of several.
    """
    rows, shape = [], ()
    for number, members in enumerate(groups.values()):
        for layer in members:
            parts = [numpy.asarray(part, dtype=float) for part in statistic(layer)]
            shape = parts[0].shape
            row = {"bond_number": number}
            for ending, part in zip(("", "_lower", "_upper"), parts):
                row |= {f"{place}{ending}": value for place, value in enumerate(numpy.ravel(part))}
            rows.append(row)
    grid = Grid(pandas.DataFrame(rows))
    results = {}
    for number, key in enumerate(groups):
        found = [grid.measured(str(place), number) for place in range(int(numpy.prod(shape)))]
        table = numpy.array([(one.value, one.lower, one.upper) for one in found], dtype=float).reshape(-1, 3)
        results[key] = tuple(part.reshape(shape) for part in table.T)
    return results
