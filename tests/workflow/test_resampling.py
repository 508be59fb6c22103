"""Intervals of block resamples against closed forms."""

import numpy
import pytest

from resampling import block_samples, counts_by_cell, interval, scattered_interval, shares, split_mix


def test_samples_are_blocks_of_neighbours_wrapped_round():
    numbers = block_samples(rows=10, block=5, resamples=200)
    assert numbers.shape == (200, 10)
    steps = numpy.diff(numbers.reshape(200, 2, 5), axis=2) % 10
    assert (steps == 1).all()
    assert set(numbers.ravel()) == set(range(10))


def test_generator_is_split_mix_64():
    assert [hex(number) for number in split_mix(0, 2).tolist()] == ["0xe220a8397b1dcdaf", "0x6e789e6aa1b965f4"]


def test_values_scattered_over_cells_are_resampled_like_rows():
    """One value in each cell is a row; cells without values leave resamples shorter."""
    values = numpy.random.default_rng(4).normal(size=30)
    rows = interval(values, numpy.mean, 5, 400)
    order = numpy.random.default_rng(5).permutation(30)
    assert scattered_interval(order, values[order], numpy.mean, 30, 5, 400) == pytest.approx(rows)
    lower, upper = scattered_interval([3, 3, 7], [1.0, 1.0, 1.0], len, 10, 1, 4000)
    assert (lower, upper) == (0, pytest.approx(7, abs=1))


def test_undefined_resamples_are_left_out():
    found = scattered_interval([0], [2.0], lambda chosen: chosen.mean() if len(chosen) else numpy.nan, 4, 1, 200)
    assert found == (2, 2)
    assert numpy.isnan(scattered_interval([], [], lambda chosen: numpy.nan, 4, 1, 200)).all()


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
