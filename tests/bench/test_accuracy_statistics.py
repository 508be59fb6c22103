"""Means, scatter and differences of replicate runs, against the textbook, SciPy and brute force."""

import math
import sys

import numpy
import pytest
import scipy.stats


@pytest.fixture(scope="module")
def statistics(root):
    """bench/accuracy/statistics_of_runs.py, which is imported by its plain name."""
    sys.path.insert(0, str(root / "bench/accuracy"))
    import statistics_of_runs

    yield statistics_of_runs
    sys.path.remove(str(root / "bench/accuracy"))


def values(numbers):
    """Replicates by their seeds."""
    return dict(enumerate(numbers, start=1))


def test_pooled_scatter_is_that_within_the_groups(statistics):
    """Against the textbook: squares about the own mean of each group, over what is free."""
    random = numpy.random.default_rng(3)
    groups = [random.normal(5, 2, size) for size in (4, 7, 9)]
    entries = [{"quantities": {"q": statistics.spread(values(group))}} for group in groups]
    pooled = statistics.pooled(entries, "q")
    squares = sum(((group - group.mean()) ** 2).sum() for group in groups)
    assert pooled["mean"] == pytest.approx(numpy.concatenate(groups).mean())
    assert pooled["scatter"] == pytest.approx((squares / (4 + 7 + 9 - 3)) ** 0.5)


def test_faults_are_counted_and_take_no_part_in_means(statistics):
    good = {"exit_code": 0, "steps": 10, "particles": 3, "simulated_seconds": 1, "energy_balance_error": -0.1}
    good |= {"largest_overlap": 0.2}
    runs = [good | {"seed": k, "processor_seconds": 10 + k, "quantities": {"q": k}} for k in (1, 3)]
    fault = {"seed": 2, "exit_code": 3, "sentence": "s", "processor_seconds": 99}
    found = statistics.summarise([*runs, fault])
    assert (found["runs"], found["faults"], found["sentences"]) == (3, 1, ["s"])
    assert found["processor_seconds"] == 12
    assert found["seconds_per_particle_step"] == pytest.approx(0.4)
    assert found["costs"]["seconds_per_particle_step"]["by_seed"] == pytest.approx({"1": 11 / 30, "3": 13 / 30})
    assert found["quantities"]["q"]["by_seed"] == {"1": 1, "3": 3}
    assert "quantities" not in statistics.summarise([fault])


def test_difference_is_that_of_scipy(statistics):
    random = numpy.random.default_rng(4)
    seeds = random.normal(5, 3, 8)  # what the placement does to both
    own, other = seeds + random.normal(0.2, 0.1, 8), seeds + random.normal(0, 0.1, 8)
    found = statistics.student_difference(values(own), values(other) | {9: 100.0})
    expected = scipy.stats.ttest_rel(own, other)
    assert found["mean"] == pytest.approx((own - other).mean())
    assert found["mean"] / found["standard_error"] == pytest.approx(expected.statistic)
    assert found["chance"] == pytest.approx(expected.pvalue)
    assert found["pairs"] == 8
    beyond = scipy.stats.ttest_1samp(own - other, 0.15, alternative="greater")
    assert statistics.student_difference(values(own), values(other), 0.15)["chance_beyond"] == pytest.approx(beyond.pvalue)
    difference = statistics.student_difference
    few = difference(values(own), values(other[:2]))  # two pairs say little: all of both
    expected = scipy.stats.ttest_ind(own, other[:2])
    assert few["mean"] / few["standard_error"] == pytest.approx(expected.statistic)
    assert (few["chance"], few["pairs"]) == (pytest.approx(expected.pvalue), 0)
    assert difference({1: 2.0}, {}) is None
    unknown = {"standard_error": None, "chance": None, "chance_beyond": None}
    assert difference({1: 2.0}, {1: 3.0}) == {"mean": -1, "pairs": 0} | unknown
    assert difference(values([2.0, 3, 4]), values([2.0, 3, 4]))["chance"] == 1


@pytest.mark.parametrize("shared", (0.0, 0.9))
def test_error_of_a_ratio_is_the_scatter_of_many_ratios(statistics, shared):
    """Against brute force, with and without what runs of the same seed share."""
    random = numpy.random.default_rng(5)

    def draw(size):
        seeds = random.normal(0, 1, size)
        return [m * (1 + 0.1 * (shared * seeds + (1 - shared**2) ** 0.5 * random.normal(0, 1, size))) for m in (3, 2)]

    relative = statistics.relative_difference
    found = [relative(values(own), values(other)) for own, other in (draw(12) for _ in range(2000))]
    assert numpy.mean([part["mean"] for part in found]) == pytest.approx(0.5, abs=0.01)
    scatter = numpy.std([part["mean"] for part in found])
    assert numpy.mean([part["standard_error"] for part in found]) == pytest.approx(scatter, rel=0.06)


def test_the_base_of_a_comparison_has_no_bar(statistics):
    import figure_choices

    spread = statistics.spread
    base = spread(values([1.0, 1.2, 0.9]))
    assert figure_choices.relative(base, base) == (0, 0)
    # Twice each run: the difference is certain, however much the runs differ.
    assert figure_choices.relative(spread(values([2.0, 2.4, 1.8])), base) == pytest.approx((100, 0))
    nothing = spread(values([None, None]))
    assert math.isnan(figure_choices.relative(nothing, base)[0])
