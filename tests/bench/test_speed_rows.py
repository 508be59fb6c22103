"""From runs to rows and tables."""

import pytest


@pytest.fixture(scope="module")
def rows(speed):
    return speed("rows")


def run(rate, processor_rate=None, others=0.0):
    return {"particles": 10, "steps": 5, "rate": rate, "processor_rate": processor_rate or rate, "time_step": 1e-7, "others": others}


def contender(speed, name, takes=True):
    return speed("contenders").Ours(name, None, {}, {}, cases=lambda case: takes)


def test_ratios_go_pair_by_pair(speed):
    assert speed("statistics_of_rates").ratios([2, 4, 9], [1, 2, 3]) == {"median": 2, "least": 2, "largest": 3, "repeats": 3}
    assert speed("statistics_of_rates").spread([]) is None


def test_a_case_has_a_row_with_what_is_missing(speed, rows):
    case = speed("contenders").Case("bed", 0, 1)
    names = ["recoat", "recoat, mixed", "recoat at abc", "LIGGGHTS", "LAMMPS granular"]
    contenders = [contender(speed, name) for name in names] + [contender(speed, "LAMMPS hertz", takes=False)]
    runs = [[run(8, 9), run(10, 9)], [None, None], [run(4, 3), run(4, 3)], [run(2), run(2, others=1.0)], [{"failed": "no mpi"}] * 2]
    (row,) = rows.case_rows([case], contenders, {(str(case), name): found for name, found in zip(names, runs)})
    assert row["rates"]["recoat"]["rate"]["median"] == 9 and row["rates"]["LIGGGHTS"]["disturbed_runs"] == 1
    assert row["rates"]["recoat, mixed"] == {"not_available": True} and row["rates"]["LAMMPS granular"] == {"failed": "no mpi"}
    assert "LAMMPS hertz" not in row["rates"] and list(row["ratios"]) == ["recoat"]
    assert row["ratios"]["recoat"]["LIGGGHTS"]["median"] == 4.5 and row["ratios"]["recoat"]["recoat at abc"]["median"] == 2.25
    assert row["processor_ratios"]["recoat"]["recoat at abc"]["median"] == 3
    assert row["ratios"]["recoat"]["LAMMPS granular"] is None


def test_a_round_that_is_missing_on_one_side_makes_no_pair(rows):
    assert rows.paired([run(2), None, run(9)], [run(1), run(1), run(3)])["repeats"] == 2
    assert rows.paired([run(2)], [None]) is None


def test_hours_are_steps_over_rate(speed, rows):
    checks = [{"particles": 1000, "time_step": 1e-7, "steps": 7_200_000, "spread_steps": 3_600_000, "rate": 1e6, "bytes_per_particle": 900}]
    slower = [checks[0] | {"rate": 2.5e5}]
    predictions = {(0, "recoat"): checks, (0, "recoat at abc"): slower}
    pieces = {(0, "recoat"): [run(1e6)], (0, "recoat at abc"): [run(5e5)]}
    (row,) = rows.whole_rows([0], ["recoat", "recoat at abc"], predictions, pieces)
    assert row["programs"]["recoat"]["check_hours"] == pytest.approx({"spreading": 1.0, "all_stages_at_most": 2.0})
    assert row["share_of_former"] == pytest.approx({"check": 0.25, "piece": 0.5})


def test_the_case_spreads_for_half_a_second(speed, build):
    today = speed("recoat").Build("today", build)
    assert speed("whole_case").spreading_time(today, 50) == pytest.approx(0.5)


def test_a_budget_stops_later_rounds_only(speed, tmp_path):
    bench = speed("bench").Bench.__new__(speed("bench").Bench)
    bench.options = type("Options", (), {"minutes": 0})()
    bench.start, bench.journal = 0.0, speed("journal").Journal(tmp_path / "journal.jsonl")
    case = speed("contenders").Case("bed", 0, 1)

    class Counting:
        name, calls = "a", 0

        def key(self, case):
            return f"a | {case}"

        def run(self, case):
            self.calls += 1
            return run(1)

    counting = Counting()
    assert len(bench.rounds([("a", counting, case)], 3)["a"]) == 1 and counting.calls == 1


def result_of(speed, rows):
    """A small result with a case that is measured and one that is not available."""
    case = speed("contenders").Case("bed", 0, 1)
    names = ["recoat", "recoat, mixed", "LIGGGHTS"]
    runs = [[run(9e6, others=1.0)], [None], [run(3e6)]]
    limits = {"threads": 1, "vectors": "avx2", "operations_double_per_second": 1e10, "operations_single_per_second": 2e10}
    limits |= {"quotients_double_per_second": 1e9, "quotients_single_per_second": 2e9, "cached_stream_bytes_per_second": 1e11, "memory_stream_bytes_per_second": 1e10}
    counts = {"scene": "bed", "bond_number": 0, "precision": "", "instructions": 600, "operations": 500, "quotients_and_roots": 50, "bytes_requested": 6000, "bytes_beyond_first_cache": 1000, "bytes_beyond_second_cache": 800}
    contenders = [contender(speed, name) for name in names]
    return {
        "command": "bench.py",
        "date": "2000-01-01",
        "machine": "one",
        "commit": "abc",
        "limits": [limits],
        "counts": [counts],
        "side_by_side": rows.case_rows([case], contenders, {(str(case), name): found for name, found in zip(names, runs)}),
        "skipped": rows.skipped_rows([{"what": "x"}], {("x", "with"): [run(1e6)], ("x", "without"): [run(2e6)]}),
        "whole_case": [],
    }


def test_the_report_says_what_was_measured_and_that_the_machine_was_busy(speed, rows):
    table, result = speed("table"), result_of(speed, rows)
    text = table.report(result)
    assert "9.00 (9.00 to 9.00)" in text and "per processor second" in text and "by processor time, over that of" in text and "The machine was busy" in text and "| 45 % | 45 % | 9 % |" in text and "| 2.00 (2.00 to 2.00) |" in text
    assert "recoat, mixed" not in table.rates(result, 1) and "Not available: recoat, mixed." in text
    assert "3.0 times LIGGGHTS" in table.sentence(result) and "2000-01-01" in table.sentence(result)


def test_tables_take_the_place_between_the_marks(speed, tmp_path):
    file = tmp_path / "performance.md"
    file.write_text("before\n<!-- begin: speed -->\nold\nold\n<!-- end: speed -->\nafter\n")
    speed("table").replace(file, "new \\1")
    assert file.read_text() == "before\n<!-- begin: speed -->\nnew \\1\n<!-- end: speed -->\nafter\n"
    file.write_text("no marks")
    with pytest.raises(SystemExit, match="marks"):
        speed("table").replace(file, "new")


def test_the_documents_have_the_marks(root):
    for name in ("docs/performance.md", "README.md"):
        text = (root / name).read_text()
        assert text.count("<!-- begin: speed") == 1 and text.count("<!-- end: speed -->") == 1, name
