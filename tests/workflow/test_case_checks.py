"""Every check of a run lets a good one pass and stops a bad one with a sentence that says what is wrong."""

import numpy
import pytest
import synthetic
from check_case import energy_balance_error, judge, refuse
from reporting import Implausible
from states import State

STAGES = ["fill", "heap", "spread"]
BOUNDS = {"energy_balance_error": 0.01, "largest_overlap": 0.01}


def good_run(particles=300):
    summary = synthetic.summary(STAGES, particles=particles)
    points = numpy.full((particles, 3), 2.5e-5)
    data = {"Id": numpy.arange(particles), "Velocity": numpy.zeros((particles, 3))}
    states = [
        State(f"{stage}.vtkhdf", points.copy(), {name: values.copy() for name, values in data.items()})
        for stage in STAGES
    ]
    metrics = {
        "layer.json": {
            "clusters": {"n_particles": 200, "cn_fraction": [0.75, 0.25], "size_fraction": {"1": 0.75, "2": 0.25}},
            "totals": {"eq14_clipped": 0.55},
        }
    }
    return summary, states, metrics


def sentence(summary, states, metrics):
    outcome = judge(summary, states, metrics, STAGES, BOUNDS)
    refuse("results/x/summary.json", summary, outcome)


def test_good_run_passes():
    sentence(*good_run())


def test_good_fill_passes():
    summary, states, metrics = good_run()
    fill = synthetic.summary(["fill"])
    outcome = judge(fill, states[:1], metrics, ["fill"], BOUNDS)
    assert all(reason is None for reason in outcome.values())


def broken(change):
    summary, states, metrics = good_run()
    change(summary, states, metrics)
    with pytest.raises(Implausible) as error:
        sentence(summary, states, metrics)
    text = str(error.value)
    assert text.startswith("Bo = 5, stiffness ratio 0.001, seed 1: ")
    assert text.endswith("(results/x/summary.json)") and "\n" not in text
    return text


def test_lost_particles():
    assert "3 of 300 particles were lost" in broken(lambda s, *_: s.update(particles_lost=3))


def test_state_with_fewer_particles():
    def shorten(summary, states, metrics):
        states[2].data["Id"] = states[2].data["Id"][:-1]

    assert "spread.vtkhdf holds 299 different particles, the run began with 300" in broken(shorten)


def test_particle_twice():
    def double(summary, states, metrics):
        states[1].data["Id"][0] = states[1].data["Id"][1]

    assert "heap.vtkhdf holds 299 different particles" in broken(double)


def test_not_a_number():
    def spoil(summary, states, metrics):
        states[2].data["Velocity"][5, 1] = numpy.nan

    assert "Velocity in spread.vtkhdf holds values that are not finite" in broken(spoil)


def test_particle_below_base():
    def sink(summary, states, metrics):
        states[0].points[7, 2] = -1e-6

    assert "fill.vtkhdf is below the base plane" in broken(sink)


def test_energy_off_by_five_percent():
    text = broken(lambda s, *_: s["energy"].update(balance_error=-5e-11))
    assert "the energy balance is off by 5 % of the blade's work (bound 1 %)" in text


def test_energy_not_a_number():
    assert "the energy balance is off" in broken(lambda s, *_: s["energy"].update(balance_error=float("nan")))


def test_energy_of_a_fill_is_held_against_the_dissipated():
    fill = synthetic.summary(["fill"])
    fill["energy"]["balance_error"] = 5e-11
    assert energy_balance_error(fill) == pytest.approx(0.05)
    assert "of the dissipated energy" in judge(fill, [], {}, ["fill"], BOUNDS)["energy balanced"]


def test_blade_without_work_is_not_good():
    assert "the energy balance is off" in broken(lambda s, *_: s["energy"].update(wall_work=0.0))


def test_overlap():
    text = broken(lambda s, *_: s["stages"][2].update(largest_overlap=0.03))
    assert "the largest overlap in stage spread is 0.03 of a particle diameter (bound 0.01)" in text


def test_overlap_not_a_number():
    assert "the largest overlap" in broken(lambda s, *_: s["stages"][0].update(largest_overlap=float("nan")))


def test_not_settled():
    assert "stage heap ended before the particles came to rest" in broken(
        lambda s, *_: s["stages"][1].update(settled=False)
    )


def test_stage_missing():
    assert "the run has no stage spread" in broken(lambda s, *_: s["stages"].pop())


def test_stopped():
    assert "the run is stopped, not finished" in broken(lambda s, *_: s.update(status="stopped"))


def test_impossible_density():
    def squeeze(summary, states, metrics):
        metrics["layer.json"]["totals"]["eq14_clipped"] = 0.8

    assert "a global packing density of 0.8 is impossible for spheres" in broken(squeeze)


def test_shares_that_do_not_sum_to_one():
    def skew(summary, states, metrics):
        metrics["layer.json"]["clusters"]["cn_fraction"] = [0.5, 0.25]

    assert "do not sum to one" in broken(skew)


def test_empty_region():
    def clear(summary, states, metrics):
        metrics["layer.json"]["clusters"]["n_particles"] = 0

    assert "no particle lies in the analysed region" in broken(clear)
