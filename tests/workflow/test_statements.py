"""Verdicts on the paper's statements."""

import numpy
import pandas
import pytest
from pore_statements import PORE_STATEMENTS, alike, dominant
from statements import LAYER_STATEMENTS, bed_independence, evaluate, inertial_lengths, ratio_statements
from verdicts import AGREES, DIFFERS, NOT_TESTABLE, Grid, between, only, trend, within


def table(name, values, half=0.01):
    """One row per Bond number of a metric with intervals of +- half."""
    return pandas.DataFrame(
        [
            {
                "bond_number": float(bond),
                "stiffness_ratio": 0.001,
                "seed": 1,
                name: value,
                f"{name}_lower": value - half,
                f"{name}_upper": value + half,
            }
            for bond, value in values.items()
        ]
    )


@pytest.mark.parametrize(
    "values, verdict",
    [
        ({5: 0.5, 50: 0.3, 200: 0.6}, AGREES),
        ({5: 0.5, 50: 0.6, 200: 0.7}, DIFFERS),
        ({5: 0.5, 50: 0.3, 200: 0.305}, NOT_TESTABLE),
        ({5: 0.3, 50: 0.305, 200: 0.2}, DIFFERS),
        ({5: 0.5, 200: 0.6}, NOT_TESTABLE),
    ],
)
def test_local_minimum(values, verdict):
    text, found = trend("m", [5, 50, 200], [-1, 1])(Grid(table("m", values)))
    assert found == verdict, text


def test_only_the_side_that_faces_the_other_value_counts():
    rows = table("m", {0: 5.0, 50: 1.0}, 0.0)
    for lower, upper, verdict in ((4.5, 20.0, AGREES), (0.5, 5.1, NOT_TESTABLE)):
        rows.loc[0, ["m_lower", "m_upper"]] = lower, upper
        assert trend("m", [0, 50], [-1])(Grid(rows))[1] == verdict


def groups(values, half=0.05):
    """Shares of pores in groups at Bo = 5."""
    rows = [table(f"pore_group_{k}", {5: value}, half) for k, value in enumerate(values)]
    return Grid(pandas.concat([row.set_index("bond_number") for row in rows], axis=1).reset_index())


@pytest.mark.parametrize(
    "values, verdict",
    [
        ([0.1, 0.2, 0.7], AGREES),
        ([0.1, 0.6, 0.3], DIFFERS),
        ([0.1, 0.42, 0.48], NOT_TESTABLE),
        ([0.1, numpy.nan, 0.7], NOT_TESTABLE),
    ],
)
def test_dominant_group(values, verdict):
    text, found = dominant("pore", 5, 2, range(3))(groups(values))
    assert found == verdict, text
    assert dominant("pore", 77, 2, range(3))(groups(values))[1] == NOT_TESTABLE


@pytest.mark.parametrize(
    "values, half, verdict",
    [
        ({0: 0.40, 1: 0.45, 5: 0.48}, 0.01, AGREES),
        ({0: 0.40, 1: 0.45, 5: 0.60}, 0.01, DIFFERS),
        ({0: 0.40, 5: 0.55}, 0.04, NOT_TESTABLE),
        ({0: 0.40, 5: numpy.nan}, 0.01, NOT_TESTABLE),
    ],
)
def test_alike(values, half, verdict):
    text, found = alike("m", between(0), 0.1)(Grid(table("m", values, half)))
    assert found == verdict, text


def test_undefined_value_proves_nothing():
    grid = Grid(table("m", {200: 0.5, 400: numpy.nan}))
    assert trend("m", [200, 400], [1])(grid) == ("Bo 200: 50 [49, 51] %; Bo 400: undefined", NOT_TESTABLE)
    assert within("m", only(400), lower=0.8)(grid)[1] == NOT_TESTABLE


def test_missing_bond_number_is_named():
    text, _ = trend("m", [5, 50, 200], [-1, 1])(Grid(table("m", {5: 0.5, 200: 0.6})))
    assert text == "no case at Bo = 50"


@pytest.mark.parametrize(
    "value, half, verdict",
    [(0.995, 0.01, AGREES), (0.95, 0.01, DIFFERS), (0.985, 0.01, NOT_TESTABLE), (0.95, numpy.nan, DIFFERS)],
)
def test_bound(value, half, verdict):
    grid = Grid(table("m", {0: value}, half))
    assert within("m", only(0), lower=0.99)(grid)[1] == verdict


def test_one_broken_bound_is_enough():
    grid = Grid(table("m", {0: 0.9, 1: 0.1, 5: 0.0}))
    assert within("m", between(0, 1), lower=0.8)(grid)[1] == DIFFERS
    assert within("m", only(0, 77), lower=0.8)(grid)[1] == AGREES
    assert within("m", only(77), lower=0.8)(grid) == ("no such case", NOT_TESTABLE)


def test_several_seeds_give_mean_and_range():
    rows = pandas.concat([table("m", {5: value}) for value in (0.2, 0.3, 0.7)])
    measured = Grid(rows).measured("m", 5)
    assert (measured.value, measured.lower, measured.upper) == pytest.approx((0.4, 0.2, 0.7))


def beds(densities, half):
    return pandas.DataFrame(
        [
            {
                "bond_number": 5.0,
                "stiffness_ratio": ratio,
                "seed": 1,
                "packing_density": value,
                "packing_density_lower": value - half,
                "packing_density_upper": value + half,
            }
            for ratio, value in densities.items()
        ]
    )


@pytest.mark.parametrize(
    "densities, half, verdict",
    [
        ({0.001: 0.5501, 0.01: 0.5505, 0.1: 0.55}, 1e-4, AGREES),
        ({0.001: 0.56, 0.01: 0.55, 0.1: 0.55}, 1e-4, DIFFERS),
        ({0.001: 0.552, 0.01: 0.55, 0.1: 0.55}, 0.01, NOT_TESTABLE),
        ({0.001: 0.60, 0.01: 0.55, 0.1: 0.55}, 0.002, DIFFERS),
        ({0.001: 0.55}, 1e-4, NOT_TESTABLE),
    ],
)
def test_bed_does_not_depend_on_stiffness(densities, half, verdict):
    text, found = bed_independence(beds(densities, half), 5)
    assert found == verdict, text


def test_layers_at_several_ratios():
    rows = pandas.concat(
        [
            table("packing_median", {5: value}, 0.001).assign(stiffness_ratio=ratio)
            for ratio, value in ((0.001, 0.30), (0.01, 0.29))
        ]
    )
    assert [row[3] for row in ratio_statements(rows)] == [AGREES, NOT_TESTABLE]


def test_every_statement_can_be_evaluated_without_its_cases():
    """A grid without cases gives no verdict."""
    empty = Grid(pandas.DataFrame({"bond_number": [], "stiffness_ratio": []}))
    for _, _, condition in LAYER_STATEMENTS + PORE_STATEMENTS:
        if condition:
            assert condition(empty)[1] == NOT_TESTABLE


def test_rows_have_figure_paper_grid_verdict():
    metrics = table("packing_median", {5: 0.3}).assign(stiffness_ratio=0.5)
    rows = evaluate(metrics, beds({0.001: 0.55, 0.1: 0.55}, 1e-4), 0.001, {0.0: 8.494733, 5.0: 1.42})
    assert all(len(row) == 4 and row[3] in (AGREES, DIFFERS, NOT_TESTABLE) for row in rows)
    assert [row[3] for row in rows[:2]] == [AGREES, NOT_TESTABLE]
    assert [row[3] for row in rows[-5:]] == [AGREES, NOT_TESTABLE, DIFFERS, NOT_TESTABLE, NOT_TESTABLE]


def test_printed_inertial_lengths_are_cut_off_not_rounded():
    exact = {bond: 0.05**2 / (2 * 0.3 * 9.81 * 5e-5 * (1 + bond)) for bond in (0.0, 1.0, 5.0, 50.0, 200.0)}
    assert [row[3] for row in inertial_lengths(exact)] == [AGREES] * 5
