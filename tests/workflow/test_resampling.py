"""Intervals of block resamples against closed forms."""

import numpy
import pytest

from resampling import block_samples, counts_by_cell, interval, shares


def test_samples_are_blocks_of_neighbours_wrapped_round():
    numbers = block_samples(rows=10, block=5, resamples=200)
    assert numbers.shape == (200, 10)
    steps = numpy.diff(numbers.reshape(200, 2, 5), axis=2) % 10
    assert (steps == 1).all()
    assert set(numbers.ravel()) == set(range(10))


def test_block_longer_than_the_layer_is_the_layer():
    numbers = block_samples(rows=4, block=100, resamples=50)
    assert (numpy.sort(numbers, axis=1) == numpy.arange(4)).all()


def test_same_interval_every_time():
    values = numpy.random.default_rng(3).normal(size=50)
    assert interval(values, numpy.mean, 5, 300) == interval(values, numpy.mean, 5, 300)


def test_interval_of_a_mean_of_independent_values():
    values = numpy.random.default_rng(1).normal(size=4000)
    lower, upper = interval(values, numpy.mean, block=1, resamples=4000)
    assert upper - lower == pytest.approx(2 * 1.95996 * values.std() / numpy.sqrt(4000), rel=0.06)


def test_blocks_see_correlation_that_single_values_do_not():
    noise = numpy.random.default_rng(2).normal(size=20000)
    values = numpy.zeros(20000)
    for i in range(1, len(values)):
        values[i] = 0.9 * values[i - 1] + noise[i]
    lower, upper = interval(values, numpy.mean, block=200, resamples=1000)
    independent = 2 * 1.95996 * values.std() / numpy.sqrt(len(values))
    expected = independent * numpy.sqrt((1 + 0.9) / (1 - 0.9))
    assert upper - lower == pytest.approx(expected, rel=0.15)


def test_counts_by_cell():
    position = numpy.array([0.0, 0.9, 1.0, 2.5, -0.1, 3.0, 1.5])
    group = numpy.array([0, 1, 1, 0, 0, 0, -1])
    table = counts_by_cell(position, 0.0, 1.0, 3, group, 2)
    assert table.tolist() == [[1, 1], [0, 1], [1, 0]]


def test_shares():
    assert shares(numpy.array([[1, 0], [2, 1]])).tolist() == [0.75, 0.25]
    assert numpy.isnan(shares(numpy.zeros((3, 2)))).all()
