"""Scalar metrics of the pores of a layer: density pores by 8 neighbours, chamber pores by rule A.

Sizes, directions and shares of fewer than FEWEST pores are given as not a number: resamples of a few pores are copies of
each other, and their interval would say that the value is certain.
"""

import numpy

from resampling import no_narrower_than_independent

DENSITY, CHAMBER = "density_pores/8", "chamber_pores/A"
GROUPS = ["0–1", "1–2", "2–3", "3–4", "4–5", "≥ 5"]  # diameters [d_p]; closed below
FEWEST = 5
EDGE = 1e-6  # a diameter this little below an edge counts as on it, as in the report


TOO_FEW = (numpy.nan, numpy.nan, numpy.nan)


def reported(layer, group, name):
    """A quantity of the report about the sizes of pores, with its interval."""
    enough = layer.estimate(group, "count")[0] >= FEWEST
    return layer.estimate(group, name) if enough else TOO_FEW


def value_and_interval(layer, x, values, statistic):
    """A statistic of values of pores, whose middles are at x, with its interval."""
    values = numpy.asarray(values, dtype=float)
    if len(values) < FEWEST:
        return TOO_FEW
    return statistic(values), *layer.pore_interval(x, values, statistic)


def interquartile_range(sizes):
    """Upper less lower quartile; not a number without pores."""
    return numpy.subtract(*numpy.percentile(sizes, [75, 25])) if len(sizes) else numpy.nan


def mean(values):
    """Not a number without pores."""
    return values.mean() if len(values) else numpy.nan


def weighted_mean(rows):
    """Mean of the first column with the weights of the second."""
    return (rows[:, 0] * rows[:, 1]).sum() / rows[:, 1].sum() if len(rows) else numpy.nan


def directed(layer):
    """x, angle to the spreading direction [degrees], elongation and cells of the density pores that have an angle."""
    pores = [pore for pore in layer.density_pores if pore.get("angle") is not None]
    table = [(pore["x"], pore["angle"], pore["elongation"], pore["cells"]) for pore in pores]
    return numpy.array(table, dtype=float).reshape(-1, 4).T


def density_scalars(layer):
    """Of density pores."""
    metrics = layer.metrics["density_pores"]["8"]
    x, diameter = numpy.array([(pore["x"], pore["diameter"]) for pore in layer.density_pores]).reshape(-1, 2).T
    place, angle, elongation, cells = directed(layer)
    nodes = layer.packing.size
    result = {
        "pore_count": layer.estimate(DENSITY, "count"),
        "pore_mean_dp": reported(layer, DENSITY, "mean"),
        "pore_median_dp": reported(layer, DENSITY, "median"),
        "pore_iqr_dp": value_and_interval(layer, x, diameter, interquartile_range),
        "pore_largest_dp": (metrics["max"], numpy.nan, numpy.nan),
        "pore_area": layer.estimate(DENSITY, "area_fraction"),
        "pore_largest_area": (max((pore["cells"] for pore in layer.density_pores), default=0) / nodes, numpy.nan, numpy.nan),
        "pore_perpendicular": value_and_interval(layer, place, numpy.stack([angle >= 45, cells], axis=1), weighted_mean),
        "pore_elongation": value_and_interval(layer, place, elongation, mean),
    }
    return result | group_shares(layer, DENSITY, "pore")


def share_in_second_half(layer, x):
    """Share of pores in the second half of the layer, by the mean number in a column of either half."""
    if len(x) < FEWEST:
        return TOO_FEW
    cell = numpy.clip(numpy.floor(x / layer.cell + 1e-6), 0, layer.cells - 1).astype(int)
    rows = numpy.column_stack([numpy.bincount(cell, minlength=layer.cells), 2 * numpy.arange(layer.cells) >= layer.cells])

    def statistic(chosen):
        later = chosen[:, 1] > 0.5
        if later.all() or not later.any() or not chosen[:, 0].any():
            return numpy.nan
        first, second = chosen[~later, 0].mean(), chosen[later, 0].mean()
        return second / (first + second)

    return statistic(rows), *layer.interval(rows, statistic)


def chamber_scalars(layer):
    """Of chamber pores."""
    x, _, diameter = layer.chambers.T

    def share(condition):
        return no_narrower_than_independent(*value_and_interval(layer, x, condition, mean), len(x))

    result = {
        "chamber_count": layer.estimate(CHAMBER, "count"),
        "chamber_mean_dp": reported(layer, CHAMBER, "mean"),
        "chamber_median_dp": reported(layer, CHAMBER, "median"),
        "chamber_iqr_dp": value_and_interval(layer, x, diameter, interquartile_range),
        "chamber_largest_dp": (layer.metrics["chamber_pores"]["A"]["max"], numpy.nan, numpy.nan),
        "chamber_below_1": share(diameter < 1 - EDGE),
        "chamber_below_2": share(diameter < 2 - EDGE),
        "chamber_below_4": share(diameter < 4 - EDGE),
        "chamber_above_3": share(diameter >= 3 - EDGE),
        "chamber_second_half": share_in_second_half(layer, x),
    }
    return result | group_shares(layer, CHAMBER, "chamber")


def group_shares(layer, group, name):
    """NAME_group_0 ... 5: shares of the pores by number."""
    parts = [numpy.broadcast_to(part, len(GROUPS)) for part in reported(layer, group, "group_number_fraction")]
    number = layer.estimate(group, "count")[0]
    return {
        f"{name}_group_{k}": no_narrower_than_independent(*(part[k] for part in parts), number)
        for k in range(len(GROUPS))
    }


def pore_scalars(layer):
    """Name -> (value, lower, upper)."""
    return density_scalars(layer) | chamber_scalars(layer)
