"""What both codes of bench/cross_code start from, and the table of their results."""

import json
import sys
from itertools import combinations

import numpy
import pytest
import scipy.stats
import yaml


@pytest.fixture(scope="module")
def scripts(root):
    """The scripts of bench/cross_code, which are imported by their plain names."""
    sys.path.insert(0, str(root / "bench/cross_code"))
    import run_case
    import starts
    import two_codes

    yield {"two_codes": two_codes, "run_case": run_case, "starts": starts}
    sys.path.remove(str(root / "bench/cross_code"))


@pytest.fixture(scope="module")
def plan(root):
    return yaml.safe_load((root / "bench/cross_code/plan.yaml").read_text())


CASE = {"particles": 60, "column": [1, 5], "width": 4}


def test_spheres_of_a_start_are_apart_across_the_period_too(scripts):
    points = scripts["starts"].random_column(CASE, 0.3, 7)
    assert len(points) == 60
    for first, second in combinations(points, 2):
        images = [numpy.linalg.norm(first - second + [0, shift, 0]) for shift in (-4, 0, 4)]
        assert min(images) > 1
    assert points[:, 0].min() >= 1.5 and points[:, 0].max() <= 4.5 and points[:, 2].min() >= 0.5


def test_a_seed_gives_one_start(scripts):
    first, again, other = (scripts["starts"].random_column(CASE, 0.3, seed) for seed in (1, 1, 2))
    assert (first == again).all() and not (first == other).any()


def test_both_codes_read_the_same_start(scripts, tmp_path):
    points = 5e-5 * scripts["starts"].random_column(CASE, 0.3, 1)
    scripts["starts"].write_table(tmp_path / "start.csv", points, 2.5e-5)
    scripts["starts"].write_data(tmp_path / "start.data", points, 2.5e-5, 4430, (0.0, 3e-4), 2e-4, 1e-3)
    table = numpy.loadtxt(tmp_path / "start.csv", delimiter=",", skiprows=1)
    data = numpy.loadtxt((tmp_path / "start.data").read_text().split("sphere\n\n")[1].splitlines())
    assert (table[:, :3] == points).all() and (data[:, 4:] == points).all()
    assert (data[:, 2] == 2 * table[:, 3]).all()


@pytest.mark.parametrize("name", ["bed", "layer"])
def test_both_codes_step_for_the_same_time(scripts, plan, name):
    case = plan["cases"][name]
    variables = scripts["run_case"].lammps_variables(plan, case)
    stages = [stage for each in scripts["run_case"].scene(plan, case)["stages"] for stage in each.values()]
    steps = sum(variables[key] for key in ("steps_before", "steps_moving", "steps_after"))
    assert steps * variables["dt"] == pytest.approx(sum(float(stage["duration"].split()[0]) for stage in stages))


def test_the_difference_is_that_of_welch(scripts):
    first, second = [0.58, 0.57, 0.59, 0.575], [0.56, 0.555, 0.575, 0.57]
    expected = abs(scipy.stats.ttest_ind(first, second, equal_var=False).statistic)
    assert scripts["two_codes"].compare(first, second)["errors_apart"] == pytest.approx(expected)


def test_the_document_holds_the_table_of_the_results(scripts, root):
    results = json.loads((root / "bench/results/cross_code.json").read_text())
    assert scripts["two_codes"].table(results) in (root / "docs/verification.md").read_text()
