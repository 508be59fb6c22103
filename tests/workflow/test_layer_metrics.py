"""Scalar metrics of layers whose truth is known."""

import json

import numpy
import pytest
from layer_metrics import by_size, cluster_scalars, doublets_among_clusters, drift, mean_cluster, particles_per_area, share_among
from layers import Layer
from pore_metrics import share_in_second_half
from resampling import no_narrower_than_independent

DIAMETER = 5e-5


class State:
    """Centres [m] only."""

    def __init__(self, x):
        self.points = numpy.column_stack([x, numpy.zeros_like(x), numpy.zeros_like(x)]) * DIAMETER


def layer(tmp_path, x, length=40, width=10, **metrics):
    """A layer of the region x = 0..length with particles at x [d_p]."""
    path = tmp_path / "layer.json"
    config = {"d_p": DIAMETER, "x_range": [0, length * DIAMETER], "y_period": width * DIAMETER}
    made = {"block_columns": 5, "resamples": 300, "seed": 1}
    path.write_text(json.dumps({"config": config, "uncertainty": made, **metrics}))
    made = Layer(0.0, 0.001, 1, str(path), "", {})
    made.__dict__["state"] = State(numpy.asarray(x, dtype=float))
    return made


def test_sizes_of_clusters(tmp_path):
    """Two single particles, three doublets, a cluster of four; one of six lies outside."""
    sizes = [1, 1] + 6 * [2] + 4 * [4] + 6 * [6]
    x = list(numpy.linspace(0.5, 39.5, 12)) + 6 * [45.0]
    found = layer(tmp_path, x, clusters={"size_fraction": {"1": 0.2, "2": 0.5, "4": 0.3}}, particles={"cluster_size": sizes})
    rows = by_size(found)
    assert rows.sum(axis=0).tolist() == [0, 2, 6, 0, 4]
    assert mean_cluster(rows) == pytest.approx((6 * 2 + 4 * 4) / 10)
    assert doublets_among_clusters(rows) == pytest.approx(3 / 4)
    assert numpy.isnan(mean_cluster(rows[:, :2])) and numpy.isnan(doublets_among_clusters(rows[:, :2]))


def test_share_among_some(tmp_path):
    found = layer(tmp_path, [1.5, 2.5, 3.5, 4.5, 50.0])
    value, lower, upper = share_among(found, numpy.array([1, 1, 1, 0, 1], bool), numpy.array([1, 0, 0, 1, 1], bool))
    assert value == pytest.approx(1 / 3)
    assert lower < 0.01 and upper > 0.9  # of one in three: exactly 0.0084 to 0.906


def test_particles_per_area(tmp_path):
    value, lower, upper = particles_per_area(layer(tmp_path, numpy.arange(0.5, 40, 0.5)))
    assert value == pytest.approx(79 / 400) and lower <= value <= upper


@pytest.mark.parametrize("rise", (0.0, 0.3))
def test_drift_is_seen_where_it_is(tmp_path, rise):
    """Packing density rising by a share from the first half to the second, with noise: the interval holds the truth."""
    dice, held = numpy.random.default_rng(11), 0
    for _ in range(60):
        columns = 1 + rise * (numpy.arange(40) >= 20) + 0.1 * dice.standard_normal(40)
        found = layer(tmp_path, [], maps={"phi_exact": numpy.repeat(columns[:, None], 10, axis=1).tolist()})
        value, lower, upper = drift(found)
        held += lower <= rise / (1 + rise / 2) <= upper
        assert lower <= value <= upper
    assert held / 60 > 0.8  # eight blocks are few: 0.87 of the intervals hold the truth


def test_what_was_not_seen_may_be_there():
    """None of 60: three in a hundred are possible with 2.5 %, as the closed form 1 - 0.025^(1/60) has it."""
    assert no_narrower_than_independent(0.0, 0.0, 0.0, 60) == pytest.approx((0, 0, 1 - 0.025 ** (1 / 60)))
    assert no_narrower_than_independent(1.0, 1.0, 1.0, 60) == pytest.approx((1, 0.025 ** (1 / 60), 1))
    assert no_narrower_than_independent(0.5, 0.1, 0.9, 1000) == (0.5, 0.1, 0.9)
    assert numpy.isnan(no_narrower_than_independent(numpy.nan, numpy.nan, numpy.nan, 0)).all()


@pytest.mark.parametrize("truth", (0.005, 0.05, 0.4))
def test_intervals_of_rare_things_hold_the_truth(truth):
    dice, held = numpy.random.default_rng(2), 0
    for seen in dice.binomial(80, truth, 400):
        share = seen / 80
        _, lower, upper = no_narrower_than_independent(share, share, share, 80)
        held += lower <= truth <= upper
    assert held / 400 > 0.94


def test_directions_and_chains(tmp_path):
    """Particles without an angle have no direction; a chain has no particle with three contacts."""
    found = layer(
        tmp_path,
        numpy.arange(1, 9),
        clusters={"size_fraction": {"1": 0.1, "2": 0.3, "3": 0.1, "5": 0.5}},
        particles={
            "cluster_size": [1, 2, 2, 5, 3, 5, 5, 2],
            "cluster_angle": [None, 10.0, 80.0, 45.0, None, 20.0, 50.0, 30.0],
            "cn": [0, 1, 1, 2, 2, 4, 3, 1],
        },
    )
    values = {name: value for name, (value, *_) in cluster_scalars(found).items()}
    assert values["perpendicular"] == pytest.approx(3 / 6)
    assert values["perpendicular_doublets"] == pytest.approx(1 / 3)
    assert values["perpendicular_large"] == pytest.approx(2 / 3)
    assert numpy.isnan(values["perpendicular_medium"])
    assert values["chain_like"] == pytest.approx(2 / 4)
    assert values["doublets_of_along"] == pytest.approx(2 / 3)
    assert values["doublets"] == pytest.approx(3 / 8) and values["clustered"] == pytest.approx(7 / 8)


def test_pores_strewn_evenly_are_known_to_be(tmp_path):
    """As many in either half: the interval is that of counts, not of where the resampled columns lie."""
    dice, held, widths = numpy.random.default_rng(4), 0, []
    for _ in range(60):
        value, lower, upper = share_in_second_half(layer(tmp_path, []), dice.uniform(0, 40, 400))
        held += lower <= 0.5 <= upper
        widths.append(upper - lower)
    assert held / 60 > 0.8
    assert numpy.mean(widths) == pytest.approx(2 * 1.96 * 0.5 / numpy.sqrt(400), rel=0.3)
    assert share_in_second_half(layer(tmp_path, []), numpy.full(20, 30.5))[0] == 1
