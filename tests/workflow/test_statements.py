"""Verdicts on the paper's statements."""

import numpy
import pandas
import pytest
from measured import Grid
from pore_statements import alike, dominant
from statements import LAYER_STATEMENTS, bed_independence, evaluate, inertial_lengths, ratio_statements, with_losses
from verdicts import FAILS, HOLDS, UNKNOWN, Judgement, between, only, trend, within


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
        ({5: 0.5, 50: 0.3, 200: 0.6}, HOLDS),
        ({5: 0.5, 50: 0.6, 200: 0.7}, FAILS),
        ({5: 0.5, 50: 0.3, 200: 0.305}, UNKNOWN),
        ({5: 0.3, 50: 0.305, 200: 0.2}, FAILS),
        ({5: 0.5, 200: 0.6}, UNKNOWN),
    ],
)
def test_local_minimum(values, verdict):
    found = trend("m", [5, 50, 200], [-1, 1])(Grid(table("m", values)))
    assert found.verdict == verdict, found


def test_only_the_side_that_faces_the_other_value_counts():
    rows = table("m", {0: 5.0, 50: 1.0}, 0.0)
    for lower, upper, verdict in ((4.5, 20.0, HOLDS), (0.5, 5.1, UNKNOWN)):
        rows.loc[0, ["m_lower", "m_upper"]] = lower, upper
        assert trend("m", [0, 50], [-1])(Grid(rows)).verdict == verdict


def groups(values, half=0.05):
    """Shares of pores in groups at Bo = 5."""
    rows = [table(f"pore_group_{k}", {5: value}, half) for k, value in enumerate(values)]
    return Grid(pandas.concat([row.set_index("bond_number") for row in rows], axis=1).reset_index())


@pytest.mark.parametrize(
    "values, verdict",
    [
        ([0.1, 0.2, 0.7], HOLDS),
        ([0.1, 0.6, 0.3], FAILS),
        ([0.1, 0.42, 0.48], UNKNOWN),
        ([0.1, numpy.nan, 0.7], UNKNOWN),
    ],
)
def test_dominant_group(values, verdict):
    found = dominant("pore", 5, 2, range(3))(groups(values))
    assert found.verdict == verdict, found
    assert dominant("pore", 77, 2, range(3))(groups(values)).verdict == UNKNOWN


@pytest.mark.parametrize(
    "values, half, verdict",
    [
        ({0: 0.40, 1: 0.45, 5: 0.48}, 0.01, HOLDS),
        ({0: 0.40, 1: 0.45, 5: 0.60}, 0.01, FAILS),
        ({0: 0.40, 5: 0.55}, 0.04, UNKNOWN),
        ({0: 0.40, 5: 0.48}, 0.04, UNKNOWN),
        ({0: 0.40, 5: numpy.nan}, 0.01, UNKNOWN),
    ],
)
def test_alike(values, half, verdict):
    found = alike("m", between(0), 0.1)(Grid(table("m", values, half)))
    assert found.verdict == verdict, found


def test_undefined_value_proves_nothing():
    grid = Grid(table("m", {200: 0.5, 400: numpy.nan}))
    found = trend("m", [200, 400], [1])(grid)
    assert (found.found, found.verdict) == ("Bo 200: 50 [49, 51] %; Bo 400: undefined", UNKNOWN)
    assert within("m", only(400), lower=0.8)(grid).verdict == UNKNOWN


def test_missing_bond_number_is_named():
    found = trend("m", [5, 50, 200], [-1, 1])(Grid(table("m", {5: 0.5, 200: 0.6})))
    assert found.found == "no case at Bo = 50"


@pytest.mark.parametrize(
    "value, half, verdict",
    [
        (0.995, 0.001, HOLDS),
        (0.995, 0.01, UNKNOWN),
        (0.95, 0.01, FAILS),
        (0.985, 0.01, UNKNOWN),
        (0.95, numpy.nan, FAILS),
    ],
)
def test_bound(value, half, verdict):
    grid = Grid(table("m", {0: value}, half))
    assert within("m", only(0), lower=0.99)(grid).verdict == verdict


def test_one_broken_bound_is_enough():
    grid = Grid(table("m", {0: 0.9, 1: 0.1, 5: 0.0}))
    assert within("m", between(0, 1), lower=0.8)(grid).verdict == FAILS
    assert within("m", only(0, 77), lower=0.8)(grid).verdict == HOLDS
    assert within("m", only(77), lower=0.8)(grid) == Judgement("no such case", UNKNOWN)


def test_of_an_extreme_value_the_largest_replicate_decides():
    rows = pandas.concat([table("m", {5: value}, numpy.nan) for value in (1.2, 1.6, 1.3)])
    assert within("m", only(5), upper=1.5, extreme=True)(Grid(rows)).verdict == FAILS
    assert within("m", only(5), upper=1.7, extreme=True)(Grid(rows)).verdict == HOLDS


def test_what_cannot_be_told_says_how_much_layer_it_takes():
    """A bound at twice the distance of half an interval takes intervals half as wide: four times the layer."""
    found = within("m", only(0), lower=0.5)(Grid(table("m", {0: 0.51}, 0.02)))
    assert (found.verdict, found.bonds) == (UNKNOWN, (0,))
    assert found.more == pytest.approx(4)
    assert trend("m", [5, 50], [1])(Grid(table("m", {5: 0.5, 50: 0.51}, 0.02))).more == pytest.approx(8)


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
        ({0.001: 0.5501, 0.01: 0.5505, 0.1: 0.55}, 1e-4, HOLDS),
        ({0.001: 0.56, 0.01: 0.55, 0.1: 0.55}, 1e-4, FAILS),
        ({0.001: 0.552, 0.01: 0.55, 0.1: 0.55}, 0.01, UNKNOWN),
        ({0.001: 0.60, 0.01: 0.55, 0.1: 0.55}, 0.002, FAILS),
        ({0.001: 0.55}, 1e-4, UNKNOWN),
    ],
)
def test_bed_does_not_depend_on_stiffness(densities, half, verdict):
    found = bed_independence(beds(densities, half), 5)
    assert found.verdict == verdict, found


def test_layers_at_several_ratios():
    rows = pandas.concat(
        [
            table(name, {5: value}, 0.001).assign(stiffness_ratio=ratio)
            for name in ("packing_median", "packing_iqr")
            for ratio, value in ((0.001, 0.295), (0.01, 0.29))
        ]
    )
    assert [found.verdict for *_, found in ratio_statements(rows)] == [HOLDS, UNKNOWN, HOLDS, UNKNOWN]


def test_every_statement_can_be_evaluated_without_its_cases():
    """A grid without cases gives no verdict."""
    empty = Grid(pandas.DataFrame({"bond_number": [], "stiffness_ratio": []}))
    for _, _, condition in LAYER_STATEMENTS:
        assert condition(empty).verdict == UNKNOWN


def test_rows_have_figure_paper_grid_verdict():
    metrics = table("packing_median", {5: 0.3}).assign(stiffness_ratio=0.5)
    rows = evaluate(metrics, beds({0.001: 0.55, 0.1: 0.55}, 1e-4), 0.001, {0.0: 8.494733, 5.0: 1.42}, losses(5.0, 0.2, 0.5, 0.3))
    verdicts = [found.verdict for _, _, found in rows]
    assert set(verdicts) == {HOLDS, FAILS, UNKNOWN}
    assert verdicts[:2] == [HOLDS, UNKNOWN]
    assert verdicts[-5:] == [HOLDS, UNKNOWN, FAILS, UNKNOWN, UNKNOWN]


def losses(bond, *parts):
    """Shares of collisions, sliding and rolling in the energy lost, with a stiffness ratio as in the tests above."""
    names = ("loss_collisions", "loss_sliding", "loss_rolling")
    case = {"bond_number": bond, "stiffness_ratio": 0.5, "seed": 1}
    return pandas.DataFrame([case | dict(zip(names, parts))])


def test_losses_of_energy_belong_to_their_case():
    metrics = table("packing_median", {0: 0.3, 5: 0.3}).assign(stiffness_ratio=0.5)
    grid = Grid(with_losses(metrics, losses(5.0, 0.2, 0.5, 0.3)))
    assert grid.measured("loss_sliding", 5).value == 0.5
    assert numpy.isnan(grid.measured("loss_sliding", 0).value)


def test_printed_inertial_lengths_are_cut_off_not_rounded():
    exact = {bond: 0.05**2 / (2 * 0.3 * 9.81 * 5e-5 * (1 + bond)) for bond in (0.0, 1.0, 5.0, 50.0, 200.0)}
    assert [found.verdict for *_, found in inertial_lengths(exact)] == [HOLDS] * 5
