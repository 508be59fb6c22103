"""Writes the table of docs/verification.md: runs its tests and takes the errors that they keep.

python tests/analytic/verification.py BUILD [TABLE]: BUILD is the build folder with the tests; TABLE the file to rewrite
between its two marks, docs/verification.md unless given. Ends with 1 if a test fails.
"""

import json
import subprocess
import sys
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
DOCUMENT = ROOT / "docs/verification.md"
BEGIN, END = "<!-- table: make verification -->", "<!-- end of table -->"
HEADER = ["Section", "Case", "Quantity", "Worst error", "Tolerance", "Reference", "Source", "Test"]
STANDARD = {"name", "file", "line", "value_param", "status", "result", "timestamp", "time", "classname", "failures"}


def cases():
    """Rows of cases.json, each with the program that has the test."""
    return [{"program": "test_analytic", **case} for case in json.loads((Path(__file__).parent / "cases.json").read_text())]


def program_path(build, program):
    return next(path for path in Path(build).glob(f"tests/**/{program}") if path.is_file())


def plain_name(suite, test):
    """Suite.test without the names of parameters."""
    return f"{suite.split('/')[-1]}.{test.split('/')[0]}"


def measure(build, program, tests):
    """{test: {quantity: (error, tolerance)}}, the worst over the parameters of a test. Raises when a test fails."""
    names = ":".join(f"{name}:*/{name}/*" for name in tests)
    with tempfile.TemporaryDirectory() as folder:
        output = Path(folder) / "tests.json"
        command = [program_path(build, program), f"--gtest_filter={names}", f"--gtest_output=json:{output}"]
        run = subprocess.run(command, capture_output=True, text=True, check=False)
        if run.returncode != 0:
            raise RuntimeError(f"{program} failed:\n{run.stdout[-3000:]}{run.stderr[-1000:]}")
        report = json.loads(output.read_text())
    found = {}
    for suite in report["testsuites"]:
        for test in suite["testsuite"]:
            quantities = found.setdefault(plain_name(suite["name"], test["name"]), {})
            for quantity, text in test.items():
                if quantity in STANDARD:
                    continue
                error, tolerance = (float(number) for number in text.split())
                if quantity not in quantities or error / tolerance > quantities[quantity][0] / quantities[quantity][1]:
                    quantities[quantity] = (error, tolerance)
    return found


def number(value):
    return f"{value:.2g}"


def rows(build):
    """Cells of the table: one row per quantity; what is said once per case stands in the first of its rows."""
    table = cases()
    found = {}
    for program in dict.fromkeys(case["program"] for case in table):
        found |= measure(build, program, [case["test"] for case in table if case["program"] == program])
    result = []
    for case in table:
        quantities = found[case["test"]]
        if not quantities:
            raise RuntimeError(f"{case['test']} keeps no error: use verify() of tests/support/verification.hpp")
        head, tail = [case["section"], case["what"]], [case["reference"], case["source"], f"`{case['test']}`"]
        for quantity, (error, tolerance) in quantities.items():
            result.append([*head, quantity, number(error), number(tolerance), *tail])
            head, tail = [""] * 2, [""] * 3
    return result


def markdown(table):
    lines = [HEADER, ["---"] * len(HEADER), *table]
    return "".join(f"| {' | '.join(cells)} |\n" for cells in lines)


def rewritten(text, table):
    """The document with the table between its marks."""
    before, rest = text.split(BEGIN)
    after = rest.split(END)[1]
    return f"{before}{BEGIN}\n\n{markdown(table)}\n{END}{after}"


def committed_rows(text):
    """Cells of the table in the document."""
    lines = text.split(BEGIN)[1].split(END)[0].strip().splitlines()
    return [[cell.strip() for cell in line.strip("|").split(" | ")] for line in lines[2:]]


if __name__ == "__main__":
    document = Path(sys.argv[2]) if len(sys.argv) > 2 else DOCUMENT
    document.write_text(rewritten(document.read_text(), rows(sys.argv[1])))
