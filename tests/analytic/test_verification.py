"""docs/verification.md lists the tests that there are, with the tolerances that they have."""

import json
import subprocess
from pathlib import Path

import pytest

HERE = Path(__file__).parent


@pytest.fixture(scope="module")
def verification():
    import sys

    sys.path.insert(0, str(HERE))
    import verification as module

    return module


@pytest.fixture(scope="module")
def committed(verification):
    return verification.committed_rows(verification.DOCUMENT.read_text())


def listed_tests(verification, build, program):
    """Names of the tests of a program, without their parameters."""
    command = [verification.program_path(build, program), "--gtest_list_tests"]
    names, suite = set(), ""
    for line in subprocess.run(command, capture_output=True, text=True, check=True).stdout.splitlines():
        name = line.split("#")[0].strip()
        if line.startswith(" "):
            names.add(verification.plain_name(suite, name))
        elif name.endswith("."):
            suite = name[:-1]
    return names


def test_every_analytic_test_is_a_case(verification, build):
    named = [case["test"] for case in verification.cases() if case["program"] == "test_analytic"]
    assert len(named) == len(set(named))
    assert set(named) == listed_tests(verification, build, "test_analytic")


def test_other_cases_are_tests(verification, build):
    for case in verification.cases():
        assert case["test"] in listed_tests(verification, build, case["program"])


def test_every_case_has_the_label_analytic(verification, build):
    command = ["ctest", "--test-dir", build, "-L", "^analytic$", "--show-only=json-v1"]
    shown = json.loads(subprocess.run(command, capture_output=True, text=True, check=True).stdout)
    program_and_test = {tuple(test["name"].split(".", 1)) for test in shown["tests"]}
    labelled = {(program, verification.plain_name(*name.split("."))) for program, name in program_and_test}
    for case in verification.cases():
        assert (case["program"], case["test"]) in labelled


def test_the_document_has_every_case_in_order(verification, committed):
    heads = [row for row in committed if row[0]]
    assert [row[:2] + row[5:] for row in heads] == [
        [case["section"], case["what"], case["reference"], case["source"], f"`{case['test']}`"]
        for case in verification.cases()
    ]


def test_the_document_has_no_error_beyond_its_tolerance(committed):
    for row in committed:
        assert float(row[3]) <= float(row[4]), row


@pytest.mark.slow
def test_the_document_has_the_tolerances_of_the_tests(verification, committed, build):
    measured = verification.rows(build)
    assert [row[:3] + row[4:] for row in measured] == [row[:3] + row[4:] for row in committed]


def test_a_case_without_numbers_is_refused(verification, monkeypatch):
    case = {"program": "p", "section": "1", "what": "w", "reference": "r", "source": "s", "test": "A.b"}
    monkeypatch.setattr(verification, "cases", lambda: [case])
    monkeypatch.setattr(verification, "measure", lambda *_: {"A.b": {}})
    with pytest.raises(RuntimeError, match="A.b keeps no error"):
        verification.rows("build")
    monkeypatch.setattr(verification, "measure", lambda *_: {"A.b": {"x": (1e-3, 2e-3), "y": (0, 1)}})
    table = verification.rows("build")
    assert table == [["1", "w", "x", "0.001", "0.002", "r", "s", "`A.b`"], ["", "", "y", "0", "1", "", "", ""]]
    text = f"before {verification.BEGIN} old {verification.END} after"
    assert verification.committed_rows(verification.rewritten(text, table)) == table
