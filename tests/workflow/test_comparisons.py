"""Conditions on several metrics, classes and slopes, each with a case that holds, one that does not, one in between."""

import numpy
import pandas
import pytest
from comparisons import falls_with_class, jointly, larger_than, largest_at, less_affected, linear, lowest_at, share_kept, slowing, varies_more
from extremes import largest_foreseen_at
from measured import Grid
from verdicts import FAILS, HOLDS, UNKNOWN, between, only, within


def grid(half=0.01, **metrics):
    """Values of each metric by Bond number, known to +- half."""
    bonds = sorted({bond for values in metrics.values() for bond in values})
    rows = []
    for bond in bonds:
        row = {"bond_number": float(bond)}
        for name, values in metrics.items():
            value = values.get(bond, numpy.nan)
            row |= {name: value, f"{name}_lower": value - half, f"{name}_upper": value + half}
        rows.append(row)
    return Grid(pandas.DataFrame(rows))


@pytest.mark.parametrize("at_50, verdict", [(0.6, HOLDS), (0.3, FAILS), (0.505, UNKNOWN)])
def test_largest_at(at_50, verdict):
    found = largest_at("m", 50, between(1))(grid(m={0: 0.9, 1: 0.5, 50: at_50, 200: 0.4}))
    assert found.verdict == verdict, found
    assert found.bonds == (50, 1, 200)


def test_the_largest_of_one_is_no_finding():
    assert largest_at("m", 50, between(1))(grid(m={50: 1.0})).verdict == UNKNOWN
    assert largest_at("m", 77, between(1))(grid(m={50: 1.0})).verdict == UNKNOWN


@pytest.mark.parametrize(
    "shares, verdict", [((0.5, 0.3, 0.1), HOLDS), ((0.5, 0.1, 0.3), FAILS), ((0.5, 0.3, 0.295), UNKNOWN)]
)
def test_falls_with_class(shares, verdict):
    classes = {f"m_{number}": {0: share} for number, share in enumerate(shares)}
    assert falls_with_class("m", 0, 3)(grid(**classes)).verdict == verdict


@pytest.mark.parametrize("later, verdict", [(0.95, HOLDS), (0.5, FAILS), (0.805, UNKNOWN), (numpy.nan, UNKNOWN)])
def test_share_kept(later, verdict):
    assert share_kept("m", 0, 200, 0.8)(grid(m={0: 1.0, 200: later})).verdict == verdict


@pytest.mark.parametrize("small, verdict", [(0.21, HOLDS), (0.6, FAILS), (0.4, UNKNOWN)])
def test_less_affected(small, verdict):
    found = less_affected("s", "l", [0, 1])(grid(s={0: 0.2, 1: small}, l={0: 0.5, 1: 0.3}))
    assert found.verdict == verdict, found


@pytest.mark.parametrize("wide, verdict", [(0.9, HOLDS), (0.51, FAILS), (0.605, UNKNOWN)])
def test_varies_more(wide, verdict):
    found = varies_more("w", "n", between(0))(grid(w={0: 0.5, 1: wide, 5: 0.5}, n={0: 0.1, 1: 0.2, 5: 0.15}))
    assert found.verdict == verdict, found


@pytest.mark.parametrize("last, verdict", [(0.45, HOLDS), (0.9, FAILS), (0.59, UNKNOWN)])
def test_slowing(last, verdict):
    """From 0.2 at 50 to 0.4 at 100: 0.8 at 200 would be a line."""
    found = slowing("m", [50, 100, 200])(grid(0.01 if verdict != UNKNOWN else 0.2, m={50: 0.2, 100: 0.4, 200: last}))
    assert found.verdict == verdict, found


def test_a_value_that_falls_does_not_rise_slowly():
    assert slowing("m", [50, 100, 200])(grid(m={50: 0.4, 100: 0.2, 200: 0.1})).verdict == FAILS


@pytest.mark.parametrize("middle, verdict", [(0.61, HOLDS), (0.9, FAILS), (0.68, UNKNOWN)])
def test_linear(middle, verdict):
    found = linear("m", 200, 400, 0.1)(grid(0.01, m={200: 0.2, 300: middle, 400: 1.0}))
    assert found.verdict == verdict, found


def test_two_points_are_no_line():
    found = linear("m", 200, 400, 0.1)(grid(m={200: 0.2, 400: 1.0}))
    assert found.verdict == UNKNOWN and "any two points lie on a line" in found.found


@pytest.mark.parametrize("second, verdict", [(0.5, HOLDS), (0.9, FAILS), (0.595, UNKNOWN)])
def test_jointly(second, verdict):
    conditions = within("a", only(0), 0.4, 0.6), within("b", only(0), 0.4, 0.6)
    found = jointly(*conditions)(grid(a={0: 0.5}, b={0: second}))
    assert found.verdict == verdict and found.bonds == (0,), found


@pytest.mark.parametrize(
    "zero, verdict", [((10, 15, 20), HOLDS), ((2, 3, 4), FAILS), ((6, 8, 10), UNKNOWN)]
)
def test_the_largest_foreseen(zero, verdict):
    """Both replicates hold the same prediction: it counts once."""
    parts = "_lower", "", "_upper"
    rows = [
        {"bond_number": float(bond)} | {f"p_paper{part}": value for part, value in zip(parts, values)}
        for bond, values in ((0, zero), (0, zero), (1, (6, 7, 8)), (50, (numpy.nan,) * 3))
    ]
    found = largest_foreseen_at("p", 0, between(0, 200), " d_p")(Grid(pandas.DataFrame(rows)))
    assert found.verdict == verdict, found
    assert "Bo 50" not in found.found


@pytest.mark.parametrize("sliding, verdict", [(0.7, HOLDS), (0.3, FAILS), (0.505, UNKNOWN)])
def test_larger_than(sliding, verdict):
    found = larger_than("s", "r", between(0, above=True))(grid(s={0: 0.1, 1: sliding}, r={0: 0.5, 1: 0.5}))
    assert found.verdict == verdict and found.bonds == (1,), found


@pytest.mark.parametrize(
    "values, verdict, said",
    [
        ({1: 0.5, 50: 0.3, 200: 0.6}, HOLDS, "lowest at Bo 50, 0.3 [0.29, 0.31]"),
        ({1: 0.5, 50: 0.3, 200: 0.305}, UNKNOWN, "may be so at Bo 50, Bo 200"),
        ({1: 0.5, 50: 0.305, 200: 0.3}, UNKNOWN, "lowest at Bo 200, 0.3 [0.29, 0.31]; may be so at Bo 50, Bo 200"),
        ({1: 0.2, 50: 0.3, 200: 0.6}, FAILS, "lowest at Bo 1"),
        ({1: 0.2, 200: 0.6, 400: 0.7}, UNKNOWN, "no case at Bo = 50"),
        ({1: numpy.nan, 50: 0.3, 200: 0.6}, UNKNOWN, "no case"),
    ],
)
def test_lowest_at(values, verdict, said):
    found = lowest_at("m", 50, between(0))(grid(m=values))
    assert found.verdict == verdict and said in found.found, found
    assert (found.more > 1) == (verdict == UNKNOWN and "may be" in found.found)
