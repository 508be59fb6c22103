"""Numbers that the figures compute themselves."""

import json
import math

import numpy
import pytest
from derived_table import flatten, table as derived_table
from fig06_coordination_number import coordination_shares
from fig10_cluster_size import class_label, shares_of as cluster_shares, size_classes
from fig12_surface_height import class_edges, class_labels, height_shares
from fig15_pore_size_distribution import cumulative
from fig16_pore_size_groups import draw_panel
from layers import Layer, by_bond
from pore_metrics import DENSITY, pore_scalars
from readable import duration, quantity
from report import cell
from runtime_table import table as runtime_table
from style import bond_panels, grouped_bars, pyplot, scale_bar
import synthetic


def layer(tmp_path, bond=5.0, **values):
    """A layer with the metrics given, the region x = 2..6 d_p."""
    path = tmp_path / "layer.json"
    diameter = 5e-5
    config = {"d_p": diameter, "x_range": [2 * diameter, 6 * diameter], "y_min": 0.0, "y_period": 4 * diameter}
    path.write_text(json.dumps({"config": config, **values}))
    return Layer(bond, 0.001, 1, str(path), "", {"block_dp": 2, "bed_block_dp": 2, "resamples": 200})


def of(shares, **more):
    """A quantity of the report with an interval."""
    values = numpy.asarray(shares, dtype=float)
    return {"value": values.tolist(), "lower": (values - 0.01).tolist(), "upper": (values + 0.02).tolist()} | more


def test_estimates_are_numbers_and_lists_with_null_as_not_a_number(tmp_path):
    quantity = {"value": None, "lower": None, "upper": 2.5}
    found = layer(tmp_path, uncertainty={"a": {"b": {"c": quantity, "d": of([0.1, 0.2])}}})
    value, lower, upper = found.estimate("a/b", "c")
    assert numpy.isnan(value) and numpy.isnan(lower) and upper == 2.5 and isinstance(value, float)
    assert found.estimate("a/b", "d")[2].tolist() == pytest.approx([0.12, 0.22])


def test_cluster_classes_are_those_of_the_report_without_single_particles(tmp_path):
    found = layer(tmp_path, uncertainty={"clusters": {"size_class_fraction": of([0.5, 0.3, 0.2], items=[1, 2, 5])}})
    assert size_classes(found) == [(2, 4), (5, None)]
    assert [class_label(*sizes) for sizes in [(2, 2), (2, 4), (5, None)]] == ["2", "2–4", "≥ 5"]
    values, lower, _ = cluster_shares({5.0: [found]})[5.0]
    assert values.tolist() == pytest.approx([0.3, 0.2]) and lower.tolist() == pytest.approx([0.29, 0.19])


def test_missing_classes_are_empty_ones(tmp_path):
    found = layer(tmp_path, uncertainty={"clusters": {"cn_fraction": of([1.0])}})
    assert [part.tolist() for part in coordination_shares({5.0: [found]}, 2)[5.0]] == [[1, 0, 0], [0.99, 0, 0], [1.02, 0, 0]]


def test_classes_of_height_are_closed_above(tmp_path):
    """0; (0, 0.75]; (0.75, 1]; (1, 1.25]; what is low is in one class, and the last class holds the highest point."""
    made = {"block_columns": 1, "resamples": 200, "seed": 1}
    found = layer(tmp_path, maps={"height": [[0.0, 0.3], [0.75, 1.0], [1.0, 1.25], [0.0, 0.9]]}, uncertainty=made)
    edges = class_edges([found])
    assert edges.tolist() == [0.75, 1.0, 1.25]
    values, lower, upper = height_shares(found, edges)
    assert values.tolist() == [0.25, 0.25, 0.375, 0.125]
    assert (lower <= values).all() and (upper >= values).all() and lower[2] < upper[2]


def test_all_that_stands_out_of_the_clearance_is_one_class(tmp_path):
    made = {"block_columns": 1, "resamples": 20, "seed": 1}
    found = layer(tmp_path, maps={"height": [[0.0, 1.5], [1.6, 2.4]]}, uncertainty=made)
    edges = class_edges([found])
    assert class_labels(edges) == ["0\n(empty)", "0–\n0.75", "0.75–\n1", "1–\n1.25", "1.25–\n1.5", "> 1.5"]
    assert height_shares(found, edges)[0].tolist() == [0.25, 0, 0, 0, 0.25, 0.5]


def test_small_bars_say_how_many_they_hold():
    axes = pyplot.figure().add_subplot()
    grouped_bars(axes, "abc", {"x": ([50, 4, 0], "black")}, {"x": ([40, 2, 0], [60, 7, 1])}, {"x": 100})
    assert [(text.get_text(), text.get_position()) for text in axes.texts] == [("4", (1.0, 7.0))]
    assert axes.get_ylim()[0] == 0


@pytest.mark.parametrize(
    "seconds, text",
    [(0.0022, "0.0022 s"), (59.4, "59.4 s"), (60, "1 min"), (250, "4 min 10 s"), (3600, "1 h"), (7530, "2 h 6 min"), (273600, "3 d 4 h")],
)
def test_durations(seconds, text):
    assert duration(seconds) == text


@pytest.mark.parametrize(
    "value, unit, text",
    [
        (2e-7, "s", "200 ns"), (2.2e-6, "s", "2.2 us"), (5e-5, "m", "50 um"), (110e9, "Pa", "110 GPa"), (2.899e-10, "kg", "289.9 ng"),
        (0.99999999, "s", "1 s"), (0, "m", "0 m"), (8.4947, "d_p", "8.495 d_p"), (math.inf, "s", "infinite"), (1e-20, "J", "1e-20 J"), (0.05, "m/s", "50 mm/s"), (1.234e7, "", "12.34 M"),
    ],
)  # fmt: skip
def test_quantities(value, unit, text):
    assert quantity(value, unit) == text


def test_cumulative_share():
    assert cumulative(numpy.array([3.0, 1.0, 1.0, 2.0]), [0.5, 1.0, 2.5, 3.0]).tolist() == [0, 0.5, 0.75, 1]
    assert numpy.isnan(cumulative(numpy.array([]), [1.0])).all()


def pores(count):
    """Density pores and chambers at x = 0.5 (large) and 2.5 (small)."""
    place = [0.5 if number % 2 else 2.5 for number in range(count)]
    density = [
        {"x": x, "diameter": 4.0 if x < 1 else 2.0, "cells": 12 if x < 1 else 3, "angle": 80.0 if x < 1 else 10.0, "elongation": 2.0}
        for x in place
    ]
    groups = of([0, 0, 0.5, 0, 0.5, 0], items=list(range(6)))
    sizes = {"count": of(count), "mean": of(3.0), "median": of(3.0), "group_number_fraction": groups}
    return {
        "maps": {"phi_exact": [[0.2] * 4] * 4},
        "density_pores": {"8": {"max": 4.0, "pores": density}},
        "chamber_pores": {"A": {"max": 4.0, "circles_x_y_d": [[x, 0.0, 4.0 if x < 1 else 0.7] for x in place]}},
        "uncertainty": {
            "block_columns": 1, "resamples": 300, "seed": 1,
            "density_pores": {"8": sizes | {"area_fraction": of(0.3)}}, "chamber_pores": {"A": sizes},
        },
    }  # fmt: skip


def test_pore_metrics(tmp_path):
    found = pore_scalars(layer(tmp_path, **pores(6)))
    assert found["pore_perpendicular"][0] == pytest.approx(12 / 15)  # by area
    assert found["pore_iqr_dp"][0] == pytest.approx(2)
    assert found["pore_largest_area"][0] == pytest.approx(12 / 16)
    assert found["pore_group_2"][0] == 0.5
    assert found["chamber_second_half"][0] == pytest.approx(0.5)
    assert found["chamber_below_1"][0] == pytest.approx(0.5)
    # A resample without a column of pores has none, or only those of the other.
    assert found["chamber_below_1"][1:] == (0, 1)
    assert found["pore_elongation"] == (2, 2, 2)


def test_few_pores_prove_nothing(tmp_path):
    found = pore_scalars(layer(tmp_path, **pores(4)))
    assert found["pore_count"][0] == 4 and found["pore_area"][0] == 0.3
    for name in ("pore_mean_dp", "pore_iqr_dp", "pore_perpendicular", "pore_group_2", "chamber_below_1"):
        assert numpy.isnan(found[name]).all(), name


def test_a_panel_without_bars_still_has_a_scale(tmp_path):
    count = {"value": 2, "lower": 1, "upper": 3}
    found = layer(tmp_path, uncertainty={"density_pores": {"8": {"count": count}}})
    axes = pyplot.figure().add_subplot()
    draw_panel(axes, {5.0: [found]}, {5.0: "black"}, DENSITY, "")
    assert axes.get_ylim() == (0, 100)
    assert "no bars" in axes.get_legend().get_texts()[0].get_text()


@pytest.mark.parametrize(("width", "length"), [(80, 10), (25, 10), (20, 5), (10, 2), (4, 1)])
def test_the_bar_of_a_map_is_shorter_than_the_map(width, length):
    axes = pyplot.figure().add_subplot()
    axes.set(xlim=(30, 30 + width), ylim=(0, 6))
    scale_bar(axes)
    begin, end = axes.lines[0].get_xdata()
    assert end - begin == pytest.approx(length) and axes.texts[0].get_text().strip() == f"{length} $d_p$"


def test_particles_outside_the_region_do_not_count(tmp_path):
    found = layer(tmp_path)
    found.__dict__["state"] = type(
        "S", (), {"points": numpy.array([[1.5, 0, 0], [2.0, 0, 0], [5.9, 0, 0], [6.0, 0, 0]]) * 5e-5}
    )
    assert found.counts([0, 0, 1, 1], 2).tolist() == [[1, 0], [0, 0], [0, 0], [0, 1]]


def test_panels_follow_the_paper():
    assert bond_panels([0, 1, 5]) == [("(a) Bo ≤ 1", [0, 1]), ("(b) Bo ≥ 1", [1, 5])]
    assert bond_panels([5, 50]) == [("", [5, 50])]
    assert bond_panels([0, 1]) == [("", [0, 1])]
    assert bond_panels([0, 50]) == [("(a) Bo ≤ 1", [0]), ("(b) Bo ≥ 1", [50])]


def test_groups_are_sorted_by_bond_number(tmp_path):
    groups = by_bond([layer(tmp_path, bond) for bond in (50.0, 0.0, 50.0)])
    assert list(groups) == [0.0, 50.0] and len(groups[50.0]) == 2


def test_derived_numbers_are_flattened_by_name():
    derived = {
        "mass": 1.0,
        "limits": [{"name": "Rayleigh", "limit": 2.0}, {"name": "contact", "limit": 3.0}],
        "range": [4, 5],
    }
    assert flatten(derived) == {
        "mass": 1.0,
        "limits.Rayleigh.limit": 2.0,
        "limits.contact.limit": 3.0,
        "range.0": 4,
        "range.1": 5,
    }


def test_derived_table_leaves_out_what_the_machine_decides():
    cases = [{"bond": 5.0, "ratio": 0.001, "seed": 1}]
    found = derived_table(cases, [{"mass": 1.0, "expected": {"seconds": 3.0}}])
    assert found.index.tolist() == ["mass"]


def test_runtime_of_a_run():
    found = runtime_table(
        [{"bond": 5.0, "ratio": 0.001, "seed": 1}], [synthetic.summary(["fill", "spread"], particles=300)]
    )
    assert found["stage"].tolist() == ["fill", "spread", "all"]
    assert found["particle_steps_per_second"].tolist() == pytest.approx([1e7, 1e7, 1e7])


@pytest.mark.parametrize(
    "value, text",
    [
        ("0.00012345678", "0.0001235"),
        ("sphere", "sphere"),
        (float("nan"), ""),
        (12345678, "12345678"),
        ("250", "250"),
        ("1e", "1e"),
    ],
)
def test_table_cells(value, text):
    assert cell(value) == text
