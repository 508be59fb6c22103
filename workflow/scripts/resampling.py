"""Intervals of single runs by the circular block bootstrap: neighbouring places of a layer are not independent.

The resamples are those of recoat-analyze, number for number, so that what is computed here and what it reports belong
together.
"""

import warnings

import numpy
from scipy.stats import beta

LEVEL = 0.95


def split_mix(seed, count):
    """The first outputs of the generator SplitMix64."""
    with numpy.errstate(over="ignore"):
        z = numpy.uint64(seed) + numpy.arange(1, count + 1, dtype=numpy.uint64) * numpy.uint64(0x9E3779B97F4A7C15)
        z = (z ^ (z >> numpy.uint64(30))) * numpy.uint64(0xBF58476D1CE4E5B9)
        z = (z ^ (z >> numpy.uint64(27))) * numpy.uint64(0x94D049BB133111EB)
    return z ^ (z >> numpy.uint64(31))


def block_samples(rows, block, resamples, seed=1):
    """Row numbers of each resample, [resamples, rows]: blocks of consecutive rows, wrapped round the end."""
    block = min(block, rows)
    blocks = -(-rows // block)
    random = (split_mix(seed, resamples * blocks) >> numpy.uint64(32)).reshape(resamples, blocks)
    starts = ((random * numpy.uint64(rows)) >> numpy.uint64(32)).astype(int)
    numbers = (starts[:, :, None] + numpy.arange(block)) % rows
    return numbers.reshape(resamples, blocks * block)[:, :rows]


def central(results):
    """Ends of the central 95 % of results, those not a number left out; not a number where fewer than two are left."""
    results = numpy.asarray(results, dtype=float)
    tail = 50 * (1 - LEVEL)
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", RuntimeWarning)
        bounds = numpy.nanpercentile(results, [tail, 100 - tail], axis=0)
    lower, upper = numpy.where(numpy.isfinite(results).sum(axis=0) < 2, numpy.nan, bounds)
    return lower, upper


def interval(values, statistic, block, resamples, seed=1):
    """Central 95 % of `statistic(values[chosen rows])` over block resamples of the first axis."""
    values = numpy.asarray(values)
    numbers = block_samples(len(values), block, resamples, seed)
    return central([statistic(values[chosen]) for chosen in numbers])


def scattered_interval(cell, values, statistic, cells, block, resamples, seed=1):
    """The same for values (rows) of which each belongs to one of the cells along x, some cells having none."""
    cell, values = numpy.asarray(cell, dtype=int), numpy.asarray(values)
    results = []
    for chosen in block_samples(cells, block, resamples, seed):
        repeats = numpy.bincount(chosen, minlength=cells)[cell]
        results.append(statistic(numpy.repeat(values, repeats, axis=0)))
    return central(results)


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


def no_narrower_than_independent(value, lower, upper, number):
    """An interval of a share of `number` things, widened to the exact binomial one where that is wider.

    Resamples of a layer without a thing have none of it either, which says nothing about the next layer.
    """
    if not (number > 0 and numpy.isfinite(value)):
        return value, lower, upper
    seen, tail = value * number, 0.5 * (1 - LEVEL)
    least = beta.ppf(tail, seen, number - seen + 1) if seen > 0 else 0.0
    most = beta.ppf(1 - tail, seen + 1, number - seen) if seen < number else 1.0
    return value, numpy.nanmin([lower, least]), numpy.nanmax([upper, most])
