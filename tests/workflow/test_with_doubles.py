"""The whole workflow on made-up results: what is drawn, what is not, and what stops it."""

import json
import re

import pandas
import pytest
import yaml

REPORT = "results/smoke/report.html"
SIZE = {"test.length": 16, "test.width": 6, "test.fill_length": 8, "test.count": 200}


def use(workflow, seeds=(1,), **settings):
    """The smoke grid with settings for the doubles."""
    path = workflow.folder / "config/smoke.yaml"
    config = yaml.safe_load(path.read_text())
    config["scene_overrides"] |= SIZE | {f"test.{key}": value for key, value in settings.items()}
    config["seeds"] = list(seeds)
    path.write_text(yaml.safe_dump(config))


def run(workflow, doubles, *options):
    return workflow(*options, "--configfile", "config/smoke.yaml", build=doubles)


def test_grid_to_report_and_nothing_to_do_afterwards(workflow, doubles):
    use(workflow)
    code, output = run(workflow, doubles)
    assert code == 0, output
    page = (workflow.folder / REPORT).read_text()
    figures = sorted((workflow.folder / "results/smoke/figures").glob("*.png"))
    assert len(figures) == 17
    assert page.count("data:image/png;base64,") == 17
    links = re.findall(r'(?:src|href)="(?!data:|#)([^"]*)"', page)
    assert sorted(links) == sorted(f"figures/{figure.stem}.pdf" for figure in figures)
    assert set(re.findall(r'href="#([^"]*)"', page)) <= set(re.findall(r'id="([^"]*)"', page))
    assert re.search(r"Of \d+ statements .*\d+ hold, \d+ do not, \d+ cannot be told", page, re.DOTALL)
    assert page.count("<table>") == page.count('<div class="scroll"><table>')
    for text in ("seed 1", "version 0.0-double", "layers/bond-50_ratio-0.001_seed-1/layer.json", "paper says"):
        assert text in page
    for figure in figures:
        assert figure.with_suffix(".pdf").read_bytes().startswith(b"%PDF")
    verdicts = pandas.read_csv(workflow.folder / "results/smoke/tables/comparison.csv")["verdict"]
    assert set(verdicts) <= {"holds", "does not hold", "cannot be told"}

    code, output = run(workflow, doubles)
    assert code == 0 and "Nothing to be done" in output

    (workflow.folder / REPORT).unlink()
    (doubles / "solver/recoat-solve").touch()
    code, output = run(workflow, doubles, "--dry-run")
    assert "simulate_layer" not in output and "report" in output


def test_an_animation_needs_states_on_the_way(workflow, doubles):
    use(workflow)
    code, output = run(workflow, doubles, "results/smoke/layers/bond-5_ratio-0.001_seed-1/animation.gif")
    assert code != 0 and "this run kept no states on the way; give output.trajectory_interval" in output, output


def test_several_seeds_are_drawn(workflow, doubles):
    use(workflow, seeds=(1, 2))
    code, output = run(
        workflow, doubles, "results/smoke/figures/fig02_global_packing.png", "results/smoke/tables/comparison.csv"
    )
    assert code == 0, output
    sources = json.loads((workflow.folder / "results/smoke/figures/fig02_global_packing.json").read_text())
    assert sources["seeds"] == [1, 2] and len(sources["files"]) == 8
    assert len(pandas.read_csv(workflow.folder / "results/smoke/tables/metrics.csv")) == 8


@pytest.mark.parametrize(
    "settings, sentence",
    [
        ({"particles_lost": 2}, "2 of 200 particles were lost"),
        ({"balance_error": "5e-11"}, "the energy balance is off by 5 % of the blade's work (bound 1 %)"),
        ({"largest_overlap": 0.2}, "the largest overlap in stage fill is 0.2 of a particle diameter (bound 0.01)"),
    ],
)
def test_implausible_result_stops_with_a_sentence(workflow, doubles, settings, sentence):
    use(workflow, **settings)
    code, output = run(workflow, doubles, "results/smoke/figures/fig13_roughness.png")
    assert code != 0 and sentence in output, output
    assert not list((workflow.folder / "results/smoke").glob("figures/*.png"))


def test_every_case_has_a_layer_before_the_second_seed_begins(workflow, doubles):
    use(workflow, seeds=(3, 1))
    code, output = run(workflow, doubles, "--cores", "1", "results/smoke/tables/metrics.csv")
    assert code == 0, output
    begun = re.findall(r"(Spreading|Checking) Bo = (\S+), stiffness ratio (\S+), seed (\d)", output)
    seeds = [seed for what, _, _, seed in begun if what == "Spreading"]
    assert seeds == ["3"] * 4 + ["1"] * 4
    # What is finished is analysed and checked before the next case begins.
    assert [what for what, *_ in begun] == ["Spreading", "Checking"] * 8
