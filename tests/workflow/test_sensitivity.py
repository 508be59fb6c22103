"""Variations: which cases they are, which state each is analysed from, and whether a change is seen where there is one."""

import numpy
import pandas
import pytest
import yaml
from sensitivity import SHOWN, compared, paragraphs


def rows(change, half=0.01):
    """Two seeds of the defaults and of one variation, at two Bond numbers, the second of which changes one metric."""
    dice, found = numpy.random.default_rng(3), []
    for kind in ("layers", "vary-heap"):
        for bond in (0.0, 50.0):
            for _ in range(2):
                row = {"kind": kind, "bond": bond}
                for name in SHOWN:
                    value = 0.5 + 0.3 * half * dice.standard_normal()
                    if (kind, bond, name) == ("vary-heap", 50.0, "roughness_dp"):
                        value += change
                    row |= {name: value, f"{name}_lower": value - half, f"{name}_upper": value + half}
                found.append(row)
    return pandas.DataFrame(found)


@pytest.mark.parametrize("change, seen", [(0.2, 1), (-0.2, 1), (0.0, 0)])
def test_a_change_is_seen_where_it_is(change, seen):
    table = compared(rows(change), {"vary-heap": "twice the heap"})
    assert len(table) == 2 * len(SHOWN)
    marked = table[table["seen"]]
    assert len(marked) == seen
    text = paragraphs(table, 8)
    assert "**Twice the heap.** Bo = 0: no difference beyond the scatter." in text
    if seen:
        assert marked.iloc[0][["bond_number", "metric"]].tolist() == [50, "roughness_dp"]
        assert marked.iloc[0]["difference"] == pytest.approx(change, abs=0.02)
        assert "Bo = 50: roughness 0." in text


SIZE = {"test.length": 16, "test.width": 6, "test.fill_length": 8, "test.count": 200}
TABLE = "results/smoke/tables/sensitivity.csv"


def test_variations_are_run_analysed_and_drawn(workflow, doubles):
    path = workflow.folder / "config/smoke.yaml"
    config = yaml.safe_load(path.read_text())
    config["scene_overrides"] |= SIZE
    config["layers"] = [{"bond_numbers": [5, 50], "stiffness_ratios": [0.001]}]
    config["variations"] = [
        {"name": "heap", "title": "a smaller heap", "set": {"test.count": 150}},
        {"name": "behind", "title": "less left out", "layer_region": {"skip_end_dp": 2}},
    ]
    path.write_text(yaml.safe_dump(config))
    options = ("--configfile", "config/smoke.yaml")
    code, output = workflow("--lint", *options, build=doubles)
    assert code == 0, output
    code, output = workflow(TABLE, *options, build=doubles)
    assert code == 0, output
    results = workflow.folder / "results/smoke"
    # The region alone changes nothing that is simulated.
    assert (results / "vary-heap/bond-5_ratio-0.001_seed-1/spread.vtkhdf").exists()
    assert not (results / "vary-behind/bond-5_ratio-0.001_seed-1/spread.vtkhdf").exists()
    table = pandas.read_csv(workflow.folder / TABLE)
    assert set(table["variation"]) == {"a smaller heap", "less left out"}
    assert (results / "figures/sensitivity.pdf").read_bytes().startswith(b"%PDF")


def test_a_variation_without_a_change_is_refused(workflow, doubles):
    path = workflow.folder / "config/smoke.yaml"
    config = yaml.safe_load(path.read_text()) | {"variations": [{"name": "none", "title": "nothing"}]}
    path.write_text(yaml.safe_dump(config))
    code, output = workflow("--dry-run", "--configfile", "config/smoke.yaml", build=doubles)
    assert code == 2 and "recoat: config/smoke.yaml, line " in output and "variations" in output, output
