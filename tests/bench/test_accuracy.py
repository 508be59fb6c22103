"""The plan of `make bench-accuracy`, its statistics, and that its results are those of the plan and the solver of today."""

import json
import math
import subprocess
import sys

import numpy
import pytest


@pytest.fixture(scope="module")
def modules(root):
    """The scripts of bench/accuracy, which import each other by their plain names."""
    sys.path.insert(0, str(root / "bench/accuracy"))
    import plan
    import recommend
    import statistics_of_runs
    import two_body_errors

    yield {"plan": plan, "recommend": recommend, "statistics": statistics_of_runs, "two_body": two_body_errors}
    sys.path.remove(str(root / "bench/accuracy"))


@pytest.fixture(scope="module")
def read_plan(root, modules):
    return modules["plan"].read_plan(root / "bench/accuracy/plan.yaml")


@pytest.fixture(scope="module")
def results(root):
    return json.loads((root / "bench/results/accuracy.json").read_text())


def test_every_run_has_a_name_of_its_own(read_plan):
    settings = [json.dumps(run.settings(), sort_keys=True) for run in read_plan.runs.values()]
    assert len(set(settings)) == len(read_plan.runs)
    assert {name for members in read_plan.groups.values() for name in members} == set(read_plan.runs)


def test_results_are_those_of_the_plan(read_plan, results):
    planned = {name: len(members) for name, members in read_plan.groups.items()}
    assert {name: sum(entry["runs"] for entry in entries) for name, entries in results["powder"].items()} == planned
    assert len(results["two_body"]) == len(read_plan.two_body)
    assert results["powder_runs"] == len(read_plan.runs)


def test_automatic_steps_are_those_of_the_solver(root, build, results):
    for case in results["two_body"]:
        settings = [f"cohesion.bond_number={case['bond']}", f"stiffness_ratio={case['ratio']}", "time_step=auto"]
        command = [build / "solver/recoat-solve", "check", root / "config/scene.yaml", "--json"]
        command += [part for setting in settings for part in ("--set", setting)]
        report = json.loads(subprocess.run(command, capture_output=True, text=True, check=True).stdout)
        assert report["time_step"] == case["automatic_step"], settings


def test_steps_are_even_on_a_logarithmic_scale(modules):
    steps = modules["two_body"].steps_from(5e-9, 10)
    assert [next(steps) for _ in range(5)] == [5e-9, 6.3e-9, 7.9e-9, 1e-8, 1.3e-8]


def test_spread_takes_the_worst_phase_with_its_sign(modules):
    spread = modules["two_body"].spread
    assert spread([0.98, 1.01], 1) == pytest.approx({"mean": -0.005, "worst": -0.02})
    assert spread([None, 1], 1) == {"mean": None, "worst": None}


def small_steps_to_pull_off(bond, ramp):
    """Load over the attraction when a sphere is twenty s_min from the wall, with steps of 1 ns of the law as written."""
    mass, gravity, radius, near, far = 4 / 3 * math.pi * 25e-6**3 * 4430, 9.81, 25e-6, 1.65e-10, 1e-7
    hertz, hold = 4 / 3 * 110e9 / (1 - 0.3**2) / 2 * radius**0.5, 2 * bond * mass * gravity
    share = -math.log(0.4) / math.hypot(math.log(0.4), math.pi)
    load, separation, speed, dt = 0.9, -((0.1 * hold / hertz) ** (2 / 3)), 0.0, 1e-9
    while separation < 20 * near:
        force = hold * (load - (near / max(separation, near)) ** 2 * (separation < far))
        if separation < 0:
            damping = 2 * share * (5 / 6 * 1.5 * hertz * mass) ** 0.5 * (-separation) ** 0.25
            force += hertz * (-separation) ** 1.5 - damping * speed
        speed += force / mass * dt
        separation += speed * dt
        load += 2 * dt / ramp
    return load


@pytest.mark.parametrize("bond", (5, 50, 400))
def test_the_pull_off_is_held_to_the_ramp_that_is_measured(modules, bond):
    """The load rises while the sphere leaves: an error of 3 % at Bo 5 if it were held to the attraction itself."""
    expected = modules["two_body"].expected_pull_off(f"{bond}", 2e-3)
    assert expected == pytest.approx(small_steps_to_pull_off(bond, 2e-3), abs=2e-4)
    longer = modules["two_body"].expected_pull_off(f"{bond}", 4e-3)
    assert (expected - 1) / (longer - 1) == pytest.approx(2 ** (2 / 3), rel=0.1)


@pytest.mark.parametrize("bond", ("5", "50", "400"))
def test_the_discrete_gradient_gives_the_pull_off_of_the_ramp(root, build, modules, read_plan, bond):
    case = read_plan.two_body[f"bond-{bond}_ratio-0.001_discrete_gradient"]._asdict()
    grid = read_plan.grid | {"phases": 1}
    found = modules["two_body"].measure(build, root / "config/scene.yaml", case, 5e-8, grid)
    error = modules["two_body"].errors_of(found, bond, float(grid["ramp"]))["pull-off force"]
    assert abs(error["worst"]) < 1e-3


def test_a_step_counts_only_up_to_the_first_failure(modules):
    rows = [{"time_step": step, "good": step not in (3, 5)} for step in (4, 1, 2, 3, 5)]
    assert modules["recommend"].longest_before_failure(rows, lambda row: row["good"]) == 2
    assert modules["recommend"].longest_before_failure(rows, lambda row: False) is None
    assert modules["recommend"].longest_before_failure(rows, lambda row: True) == 5


def test_gain_compares_costs_at_the_same_error(modules):
    def case(scheme, errors, seconds):
        worst = [{f"capture velocity, {kind}": {"worst": error} for kind in ("pair", "wall")} for error in errors]
        steps = zip((1e-8, 2e-8, 4e-8), worst, seconds)
        rows = [{"time_step": step, "errors": error, "processor_seconds": cost} for step, error, cost in steps]
        return {"bond": 5, "ratio": 0.001, "scheme": scheme, "steps": rows}

    cases = [
        case("discrete_gradient", (1e-3, -5e-3, 9e-3), (8, 4, 2)),
        case("explicit_force", (2e-3, 0.02, 1e-3), (6, 3, 1.5)),
        case("prediction_correction", (0.02, 0.02, None), (6, 3, 1.5)),
    ]
    rows = modules["recommend"].gain_at_equal_error(cases)
    assert [(row["scheme"], row["longest_step"], row["gain"]) for row in rows] == [
        ("discrete_gradient", 4e-8, 1),
        ("explicit_force", 1e-8, 3),
    ]


def test_pooled_scatter_is_that_within_the_groups(modules):
    """Against the textbook: squares about the own mean of each group, over what is free."""
    random = numpy.random.default_rng(3)
    groups = [random.normal(5, 2, size) for size in (4, 7, 9)]
    runs = [[{"exit_code": 0, "quantities": {"q": value}} for value in group] for group in groups]
    entries = [{"quantities": {"q": modules["statistics"].spread(members, "q")}} for members in runs]
    pooled = modules["statistics"].pooled(entries, "q")
    squares = sum(((group - group.mean()) ** 2).sum() for group in groups)
    assert pooled["mean"] == pytest.approx(numpy.concatenate(groups).mean())
    assert pooled["scatter"] == pytest.approx((squares / (4 + 7 + 9 - 3)) ** 0.5)


def test_a_layer_that_is_off_is_not_recommended(modules):
    def entry(step, values):
        runs = [{"exit_code": 0, "quantities": {"q": value}} for value in values]
        return {
            "kind": "layer",
            "bond": 5,
            "time_step": step,
            "faults": 0,
            "energy_balance_error": 1e-3,
            "quantities": {"q": modules["statistics"].spread(runs, "q")},
        }

    near = [entry(2e-8, [1.0, 1.1, 0.9]), entry(1e-7, [1.05, 0.95, 1.0]), entry(2e-7, [1.5, 1.4, 1.6])]
    (found,) = modules["recommend"].recommended_steps([], near)["powder"]
    assert found["longest_step"] == 1e-7
    near[1]["faults"] = 1
    (found,) = modules["recommend"].recommended_steps([], near)["powder"]
    assert found["longest_step"] == 2e-8
