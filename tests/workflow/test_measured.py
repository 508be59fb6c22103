"""Intervals of means over replicates hold the truth as often as they say."""

import numpy
import pandas
import pytest
from measured import NORMAL, Grid

BONDS, SEEDS = (0.0, 1.0, 5.0, 50.0, 200.0), 3


def made_up(dice, own_scatter, told_scatter, bonds=BONDS, seeds=SEEDS):
    """Runs about a truth of 10 Bo whose bootstrap tells less or more than all of their scatter."""
    half = NORMAL * told_scatter
    rows = [
        {"bond_number": bond, "m": value, "m_lower": value - half, "m_upper": value + half}
        for bond in bonds
        for value in 10 * bond + own_scatter * dice.standard_normal(seeds)
    ]
    return Grid(pandas.DataFrame(rows))


def share_that_holds(own_scatter, told_scatter, **options):
    dice, held = numpy.random.default_rng(7), []
    for _ in range(120):
        grid = made_up(dice, own_scatter, told_scatter, **options)
        for bond in grid.bonds():
            measured = grid.measured("m", bond)
            held.append(measured.lower <= 10 * bond <= measured.upper)
    return numpy.mean(held)


def test_the_bootstrap_is_enough_where_it_tells_all_scatter():
    assert share_that_holds(1, 1) == pytest.approx(0.96, abs=0.025)


@pytest.mark.parametrize("told", (0.3, 0.7))
def test_replicates_widen_intervals_that_are_too_narrow(told):
    assert share_that_holds(1, told) == pytest.approx(0.95, abs=0.025)


def test_without_replicates_nothing_tells_that_the_bootstrap_is_too_narrow():
    assert share_that_holds(1, 0.3, seeds=1) < 0.6


def test_replicates_alone_give_an_interval_where_the_bootstrap_has_none():
    assert share_that_holds(1, numpy.nan) == pytest.approx(0.95, abs=0.025)


def test_the_mean_of_more_runs_is_known_better():
    dice = numpy.random.default_rng(3)
    few, many = (made_up(dice, 1, 3, seeds=seeds).measured("m", 5.0) for seeds in (2, 32))
    assert few.upper - few.lower == pytest.approx(4 * (many.upper - many.lower))
    assert len(many.runs) == 32
