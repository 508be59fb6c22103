"""Intervals of single runs by the circular block bootstrap: neighbouring places of a layer are not independent."""

import numpy

LEVEL = 0.95


def block_samples(rows, block, resamples, seed=0):
    """Row numbers of each resample, [resamples, rows]: blocks of consecutive rows, wrapped round the end."""
    block = min(block, rows)
    blocks = -(-rows // block)
    starts = numpy.random.default_rng(seed).integers(0, rows, size=(resamples, blocks))
    numbers = (starts[:, :, None] + numpy.arange(block)) % rows
    return numbers.reshape(resamples, blocks * block)[:, :rows]


def interval(values, statistic, block, resamples):
    """Central 95 % of `statistic(values[chosen rows])` over block resamples of the first axis."""
    values = numpy.asarray(values)
    numbers = block_samples(len(values), block, resamples)
    results = numpy.array([statistic(values[chosen]) for chosen in numbers], dtype=float)
    tail = 50 * (1 - LEVEL)
    lower, upper = numpy.nanpercentile(results, [tail, 100 - tail], axis=0)
    return lower, upper


def counts_by_cell(position, start, cell, cells, group, groups):
    """How many particles of each group have their centre in each of the cells along x, [cells, groups].

    `group` is the group number of each particle; particles outside the cells or with a negative group are left out.
    """
    number = numpy.floor((position - start) / cell + 1e-6).astype(int)
    used = (number >= 0) & (number < cells) & (group >= 0) & (group < groups)
    table = numpy.zeros((cells, groups))
    numpy.add.at(table, (number[used], group[used]), 1)
    return table


def shares(counts):
    """Shares of the groups in the sum over the cells; not a number where nothing was counted."""
    total = numpy.asarray(counts).sum(axis=0)
    return total / total.sum() if total.sum() else numpy.full(total.shape, numpy.nan)
