"""Stopping distances of particles whose way is known."""

import numpy
import pytest
import synthetic
from reporting import Implausible
from states import State
from stopping import begin_of_spread, rear_edge, releases, speed, summarised

DIAMETER = 5e-5
SPEED = 0.05


def final_state(length_dp=40):
    info = {
        "diameter": DIAMETER,
        "blade_start": 0.0,
        "spread_length": length_dp * DIAMETER,
        "config": "blade: {clearance: 1.5 dp, speed: 50 mm/s, lift_speed: 25 mm/s}",
    }
    return State("", numpy.zeros((0, 3)), {}, info)


def run_times():
    summary = synthetic.summary(["fill", "heap", "spread"])
    for stage, time in zip(summary["stages"], (0.010, 0.020, 0.100)):
        stage["time"] = time
    return summary


def test_the_blade_is_lifted_moves_and_stops():
    edge = rear_edge(final_state(), run_times())
    begin = 0.030 + 1.5 * DIAMETER / 0.025
    assert begin_of_spread(run_times()) == pytest.approx(0.030)
    assert edge([0.0, begin]).tolist() == [0, 0]
    assert float(edge(begin + 0.01)) == pytest.approx(0.01 * SPEED)
    assert float(edge(1.0)) == pytest.approx(40 * DIAMETER)


@pytest.mark.parametrize("friction", (0.1, 0.3, 0.6))
def test_a_particle_that_slides_stops_after_its_inertial_length(friction):
    """Released at the speed of the blade, slowed by mu g: V^2 / (2 mu g) beyond the place of release."""
    edge = rear_edge(final_state(400), run_times())
    moments = numpy.arange(0, 0.4, 5e-4)
    begin, release = 0.030 + 1.5 * DIAMETER / 0.025, 20 * DIAMETER
    slowing = friction * 9.81
    # A hair faster than the blade until the edge is there: it passes where the particle begins to slow down.
    since = numpy.clip(moments - (begin + release / SPEED), 0, SPEED / slowing)
    way = numpy.where(since > 0, release + SPEED * since - 0.5 * slowing * since**2, edge(moments) + 1e-12)
    found = releases(way[:, None], moments, edge)
    expected = SPEED**2 / (2 * slowing)
    assert (way[-1] - found[0]) == pytest.approx(expected, abs=0.02 * DIAMETER + 0.01 * expected)


def test_who_is_never_passed_has_no_distance():
    edge = rear_edge(final_state(), run_times())
    moments = numpy.linspace(0, 0.2, 50)
    always_ahead, always_behind = numpy.full(50, 100 * DIAMETER), numpy.full(50, -DIAMETER)
    assert numpy.isnan(releases(numpy.column_stack([always_ahead, always_behind]), moments, edge)).all()


def test_at_rest_in_the_way_of_the_edge_no_distance_at_all():
    edge = rear_edge(final_state(), run_times())
    moments = numpy.linspace(0, 0.2, 50)
    found = releases(numpy.full((50, 1), 12.3 * DIAMETER), moments, edge)
    assert found[0] == pytest.approx(12.3 * DIAMETER)


def test_summary_and_refusals():
    found = summarised(numpy.arange(101.0), {"paper": 8.5}, 7)
    assert (found["lower_quartile"], found["median"], found["upper_quartile"], found["largest_twentieth"]) == (25, 50, 75, 95)
    assert found["particles"] == 101 and found["inertial_length"] == {"paper": 8.5}
    with pytest.raises(Implausible, match="no particle of the analysed region"):
        summarised(numpy.array([]), {}, 7)
    assert speed("50 mm/s") == pytest.approx(0.05)
    with pytest.raises(Implausible, match="not a speed"):
        speed("50 mph")
