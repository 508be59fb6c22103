"""What is foreseen of the largest of a larger layer comes true as often as it says."""

import numpy
import pandas
import pytest
from extremes import extreme, prediction
from verdicts import FAILS, HOLDS, UNKNOWN


def clusters(dice, area):
    """A made-up layer: sizes with a geometric tail, 0.2 of them per unit of area."""
    return dice.geometric(0.25, dice.poisson(0.2 * area))


@pytest.mark.parametrize("times", (1, 8))
def test_the_largest_of_another_layer_lies_within(times):
    dice, within = numpy.random.default_rng(5), 0
    for _ in range(150):
        lower, _, upper = prediction(clusters(dice, 2000), 2000, times * 2000)
        within += lower <= clusters(dice, times * 2000).max() <= upper
    assert within / 150 > 0.88


def test_a_larger_layer_has_larger_extremes():
    sizes = clusters(numpy.random.default_rng(5), 2000)
    same, larger = (prediction(sizes, 2000, area)[1] for area in (2000, 20000))
    assert larger - same == pytest.approx(numpy.log(10) / -numpy.log(0.75), rel=0.4)


def test_few_sizes_foresee_nothing():
    assert prediction([1, 2, 3], 100, 1000) is None
    assert prediction([], 100, 1000) is None


def row(lower, middle, upper):
    name = "largest_cluster_paper"
    values = {"bond_number": 0.0, "largest_cluster": 60, "extremes_area": 4000.0}
    return pandas.DataFrame([values | {name: middle, f"{name}_lower": lower, f"{name}_upper": upper}])


@pytest.mark.parametrize(
    "interval, verdict", [((90, 120, 200), HOLDS), ((60, 80, 110), FAILS), ((numpy.nan,) * 3, UNKNOWN)]
)
def test_the_printed_value_is_held_against_the_prediction(interval, verdict):
    from measured import Grid

    found = extreme("largest_cluster", 0, 136, " particles")(Grid(row(*interval)))
    assert found.verdict == verdict, found
    assert found.found.startswith("60 particles on 4e+03 d_p² in all")
