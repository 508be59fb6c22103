"""Figures and verdicts have the same intervals."""

from types import SimpleNamespace

import numpy
import pandas
import pytest
from measured import Grid
from replicates import over_replicates

SIDES = numpy.array([0.01, 0.02])


def runs(*values):
    """Layers of which each knows two numbers."""
    return [SimpleNamespace(values=numpy.array(pair, dtype=float)) for pair in values]


def statistic(layer):
    return layer.values, layer.values - SIDES, layer.values + 2 * SIDES


def test_one_run_has_its_bootstrap_interval():
    found = over_replicates({0.0: runs((0.1, 0.5)), None: runs((0.3, 0.7))}, statistic)
    for key, values in ((0.0, [0.1, 0.5]), (None, [0.3, 0.7])):
        for part, expected in zip(found[key], statistic(runs(values)[0])):
            assert part == pytest.approx(expected)


def test_several_runs_have_the_interval_of_the_verdicts():
    groups = {0.0: runs((0.1, 0.5), (0.2, 0.5)), 5.0: runs((0.3, 0.7), (0.31, 0.8), (0.35, 0.6))}
    found = over_replicates(groups, statistic)
    table = pandas.DataFrame(
        {"bond_number": bond, "second": run.values[1], "second_lower": run.values[1] - 0.02, "second_upper": run.values[1] + 0.04}
        for bond, members in groups.items()
        for run in members
    )
    for bond in groups:
        expected = Grid(table).measured("second", bond)
        assert [part[1] for part in found[bond]] == pytest.approx([expected.value, expected.lower, expected.upper])
    assert found[0.0][0] == pytest.approx([0.15, 0.5])


def test_a_single_number_stays_one():
    value, lower, upper = over_replicates({1.0: runs((0.1, 0.5))}, lambda layer: (layer.values[0], 0.0, 0.3))[1.0]
    assert (float(value), float(lower), float(upper)) == pytest.approx((0.1, 0.0, 0.3))


def test_what_is_undefined_in_one_run_is_told_by_the_others():
    value, lower, upper = over_replicates({1.0: runs((0.1, numpy.nan), (0.1, 0.4))}, statistic)[1.0]
    assert value == pytest.approx([0.1, 0.4]) and upper[1] == pytest.approx(0.44)
