"""The committed table of reference numbers is what the script computes, and what docs/physics.md prints."""

import json
from pathlib import Path

import pytest

HERE = Path(__file__).parent

# Numbers of docs/physics.md, as printed there: sections 5.1, 1.4, 2.6, 5.4, 5.5, 5.7.
PRINTED = {
    "elastic.glass.overlap": 2.7411270209e-4,
    "elastic.glass.force": 1.0696888984e4,
    "elastic.glass.duration": 4.0339455688e-5,
    "elastic.limestone.duration": 5.4201004935e-5,
    "elastic.aluminium.overlap": 4.9717175242e-5,
    "elastic.magnesium.force": 7.2326810260e3,
    "restitution.0.1.duration": 1.51065993,
    "restitution.0.4.out": 0.4,
    "restitution.0.4.clipped": 0.47201398,
    "restitution.0.9.clipped": 0.90202607,
    "capture.pair.1": 2.740840310e-4,
    "capture.pair.5": 6.407185846e-4,
    "capture.pair.50": 2.317714347e-3,
    "capture.pair.200": 5.388293959e-3,
    "capture.pair.400": 8.443233621e-3,
    "capture.wall.5": 6.495611273e-4,
    "capture.wall.50": 2.391932546e-3,
    "capture.wall.400": 8.955480570e-3,
    "rebound.pair.5.1.05": 7.966196e-5,
    "rebound.pair.50.1.5": 9.830985e-4,
    "rebound.pair.400.2": 5.422284e-3,
    "rebound.pair.400.5": 1.601464e-2,
    "rebound.pair.400.fast": 1.917872e-2,
    "release.time": 4.1925e-7,
    "release.speed": 1.93785e-3,
    "stop.0.distance": 182.740359514,
    "stop.5.distance": 16.612759956,
    "stop.50.time": 5.046376197e-3,
    "stop.400.roll_start": 0.005299426,
    "stop.400.distance": 0.228140274,
    "stop.50.pure_rolling": 3.532463,
    "oxide.5.restitution": 0.845944,
    "oxide.10.spin": -273.143,
    "oxide.20.rebound": -10.1709,
    "oxide.80.restitution": 0.967880,
    "steel.1.68.recoil": -0.660622,
    "steel.2.spin": -2.167281,
    "steel.13.recoil": 6.0,
    "alloy.0.57735.recoil": -0.08328,
    "alloy.5.67128.recoil": 7.14256,
    "powder.damped.0.1.recoil": 0.00632816,
    "powder.damped.1.impulse": -0.32501580,
    "powder.undamped.0.5.recoil": -0.26286510,
    "oblique.1.0.1.x": -1.943362225e-2,
    "oblique.1.0.9.y": -2.346214074e-2,
    "oblique.0.001.0.5.y": -2.328414383e-2,
    "oblique.0.001.0.5.spin": 8.143024532e2,
    "oblique.0.001.0.9.spin": 9.064950302e2,
    "oblique.0.001.0.9.duration": 5.192505e-6,
}


@pytest.fixture(scope="module")
def committed():
    return json.loads((HERE / "reference.json").read_text())


def test_the_script_gives_the_committed_numbers(committed, monkeypatch):
    monkeypatch.syspath_prepend(str(HERE))
    from reference import reference_table

    computed = reference_table()
    assert computed.keys() == committed.keys()
    for name, value in computed.items():
        assert value == pytest.approx(committed[name], rel=1e-7, abs=1e-8), name


@pytest.mark.parametrize("name", PRINTED)
def test_the_committed_numbers_are_those_of_the_documentation(committed, name):
    digits = len(f"{PRINTED[name]:.12g}".lstrip("-0.").split("e")[0].replace(".", ""))
    assert committed[name] == pytest.approx(PRINTED[name], rel=2 * 10.0 ** -min(digits - 1, 8))
