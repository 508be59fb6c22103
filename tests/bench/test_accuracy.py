"""The plan of `make bench-accuracy`, what follows from its runs; the results are those of plan and solver of today."""

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
    import collect
    import figure_two_body
    import plan
    import recommend
    import statistics_of_runs
    import two_body_errors

    yield {
        "collect": collect,
        "figure": figure_two_body,
        "plan": plan,
        "recommend": recommend,
        "statistics": statistics_of_runs,
        "two_body": two_body_errors,
    }
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
    assert len(results["two_body"]) + len(results["two_body_mixed"]) == len(read_plan.two_body)
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
    case = read_plan.two_body[f"bond-{bond}_ratio-0.001_discrete_gradient_double"]._asdict()
    grid = read_plan.grid | {"phases": 1}
    found = modules["two_body"].measure(build, root / "config/scene.yaml", case, 5e-8, grid)
    error = modules["two_body"].errors_of(found, bond, float(grid["ramp"]))["pull-off force"]
    assert abs(error["worst"]) < 1e-3


def test_a_step_counts_only_up_to_the_first_failure(modules):
    rows = [{"time_step": step, "good": step not in (3, 5)} for step in (4, 1, 2, 3, 5)]
    assert modules["recommend"].longest_before_failure(rows, lambda row: row["good"]) == 2
    assert modules["recommend"].longest_before_failure(rows, lambda row: False) is None
    assert modules["recommend"].longest_before_failure(rows, lambda row: True) == 5


def test_gain_compares_the_cheapest_good_steps(modules):
    """The cheapest, not the longest: a longer one may need a dearer solve of the pair, and err more."""

    def case(scheme, errors, seconds):
        worst = [{f"capture velocity, {kind}": {"worst": error} for kind in ("pair", "wall")} for error in errors]
        steps = zip((1e-8, 2e-8, 4e-8), worst, seconds)
        rows = [{"time_step": step, "errors": error, "processor_seconds": cost} for step, error, cost in steps]
        return {"bond": 5, "ratio": 0.001, "scheme": scheme, "steps": rows}

    cases = [
        case("discrete_gradient", (1e-3, -5e-3, 9e-3), (8, 2, 4)),
        case("explicit_force", (2e-3, 0.02, 1e-3), (6, 3, 1.5)),
        case("prediction_correction", (0.02, 0.02, None), (6, 3, 1.5)),
    ]
    rows = modules["recommend"].gain_at_equal_error(cases)
    keys = ("scheme", "longest_step", "cheapest_step", "capture_error", "gain")
    assert [tuple(row[key] for key in keys) for row in rows] == [
        ("discrete_gradient", 4e-8, 2e-8, 5e-3, 1),
        ("explicit_force", 1e-8, 1e-8, 2e-3, 3),
    ]


def test_a_step_costs_what_a_bed_does_at_that_very_step(modules):
    """The solve of a pair gets six times dearer between two steps of the grid: no other row will do."""

    def cost(steps, known):
        rows = [{"bond": 5, "scheme": "s", "precision": "double", "time_step": step, "rate": rate} for step, rate in known.items()]
        case = {"bond": 5, "scheme": "s", "precision": "double", "ratio": 0.001, "steps": [{"time_step": step} for step in steps]}
        return [row["processor_seconds"] for row in modules["collect"].with_cost(case, rows)["steps"]]

    known = {5e-9: 4e6, 2e-8: 5e6, 1e-7: 6e6, 1.3e-7: 1e6}
    assert cost([1.3e-7], known) == pytest.approx([1 / 1.3e-7 / 1e6])
    assert cost([6.3e-9, 1.6e-8], known) == pytest.approx([1 / 6.3e-9 / 4e6, 1 / 1.6e-8 / 5e6])
    with pytest.raises(modules["collect"].Implausible, match="at a step of 1.25e-07 s"):
        cost([1.25e-7], known)


def test_results_of_different_solvers_are_not_put_together(modules):
    version = modules["collect"].version_of_all
    assert version({"a.json": {"version": "1"}, "b.json": {"version": "1"}}) == "1"
    for other in ({"version": "2"}, {}, []):
        with pytest.raises(modules["collect"].Implausible, match=r"1 \(a.json\), .* \(b.json\)"):
            version({"a.json": {"version": "1"}, "b.json": other})


def test_seconds_are_summed_over_all_parts(modules):
    records = {"powder": [{"wall_seconds": 1.5}, {"wall_seconds": 2}], "two_body": [{"wall_seconds": 4}]}
    found = modules["collect"].sums(records, "wall_seconds")
    assert found == {"powder": 3.5, "two_body": 4, "total": 7.5}


def test_a_step_is_hollow_where_a_shorter_one_costs_less(modules):
    case = {"steps": [{"processor_seconds": seconds} for seconds in (8, 4, 5, 2, 9, 1)]}
    assert list(modules["figure"].dearer(case)) == [False, False, True, False, True, False]


def values(numbers):
    """Replicates by their seeds."""
    return dict(enumerate(numbers, start=1))


def powder_entry(modules, step, numbers, faults=0):
    """A setting with one quantity."""
    return {
        "kind": "layer",
        "bond": 5,
        "time_step": step,
        "runs": len(numbers) + faults,
        "faults": faults,
        "energy_balance_error": 1e-3,
        "quantities": {"q": modules["statistics"].spread(values(numbers))},
    }


def longest(modules, entries):
    (found,) = modules["recommend"].recommended_steps([], entries)["powder"]
    return found["longest_step"]


def test_a_layer_that_is_off_is_not_recommended(modules):
    near = [
        powder_entry(modules, 2e-8, [1.0, 1.1, 0.9]),
        powder_entry(modules, 1e-7, [1.05, 0.95, 1.0]),
        powder_entry(modules, 2e-7, [1.5, 1.4, 1.6]),
    ]
    assert longest(modules, near) == 1e-7
    near[1]["faults"] = 1
    assert longest(modules, near) == 2e-8


def test_a_short_step_is_held_to_the_shorter_ones_and_not_to_itself(modules):
    usual, off = [1.0, 1.1, 0.9, 1.05, 0.95], [2.0, 2.1, 1.9, 2.04, 1.96]
    entries = [powder_entry(modules, 2e-8, usual), powder_entry(modules, 5e-8, off), powder_entry(modules, 1e-7, off)]
    assert longest(modules, entries) == 2e-8
    rows = modules["recommend"].powder_rows(entries)
    assert [[part["time_step"] for part in row["reference"]] for row in rows] == [[], [2e-8], [2e-8, 5e-8]]
    shift = rows[1]["shift"]
    assert shift["difference"] == pytest.approx(1)
    variances = [numpy.var(values, ddof=1) for values in (usual, off, off)]
    assert shift["scatters"] == pytest.approx(1 / numpy.mean(variances) ** 0.5)
    differences = numpy.subtract(off, usual)
    assert shift["standard_errors"] == pytest.approx(1 / (numpy.std(differences, ddof=1) / 5**0.5))
    assert rows[0]["shift"] is None


def test_a_step_is_refused_for_what_is_surely_off_by_more_than_a_scatter(modules):
    usual = [1.0, 1.2, 0.8, 1.1, 0.9]
    by_chance, surely_but_less, surely = [1.3, 1.0, 1.25, 1.1, 1.2], [1.1, 1.29, 0.9, 1.2, 1.01], [1.4, 1.61, 1.19, 1.5, 1.3]
    for values, expected in ((by_chance, 1e-7), (surely_but_less, 1e-7), (surely, 2e-8)):
        entries = [powder_entry(modules, 2e-8, usual), powder_entry(modules, 1e-7, values)]
        (row,) = modules["recommend"].powder_rows(entries)[1:]
        assert (row["shift"]["scatters"] > 1) == (values is not surely_but_less)
        assert (row["shift"]["chance_of_any"] > 0.05) == (values is by_chance)
        assert longest(modules, entries) == expected
