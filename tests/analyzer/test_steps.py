"""Several time steps in one file."""

import csv
import json
import subprocess

import h5py
import numpy as np
import pytest

STEPS = {100: 0.0, 250: 0.4, 900: 0.9}  # number: share of the particles that is moved
OPTIONS = ["--set", "h_b=1.5", "--set", "density=1", "--set", "voxels_per_dp=[]", "--set", "bootstrap_resamples=50"]


@pytest.fixture(scope="module")
def dump(tmp_path_factory):
    """A LAMMPS dump of spheres of diameter 1 on a plate of 20 x 6, with three steps."""
    file = tmp_path_factory.mktemp("dump") / "layer.dump"
    generator = np.random.default_rng(7)
    text = ""
    for number, moved in STEPS.items():
        place = np.column_stack([np.repeat(np.arange(20) + 0.5, 4), np.tile(np.arange(4) * 1.5 + 0.5, 20)])
        chosen = generator.random(len(place)) < moved
        place[chosen] += generator.uniform(-0.4, 0.4, (chosen.sum(), 2))
        text += f"ITEM: TIMESTEP\n{number}\nITEM: NUMBER OF ATOMS\n{len(place)}\nITEM: BOX BOUNDS ff pp ff\n0 20\n0 6\n0 2\nITEM: ATOMS id x y z radius\n"
        for index, (x, y) in enumerate(place):
            text += f"{index + 1} {x} {y} 0.5 0.5\n"
    file.write_text(text)
    return file


@pytest.fixture(scope="module")
def run(build):
    def call(*arguments):
        return subprocess.run([build / "analyzer/recoat-analyze", *map(str, arguments)], capture_output=True, text=True, check=False)

    return call


def test_every_step_is_measured_as_it_is_alone(run, dump, tmp_path):
    region = ["--region", "1,19"]
    done = run("metrics", dump, "--step", "all", "--json", tmp_path / "all.json", "--out", tmp_path / "all.h5", "--csv", tmp_path, *region, *OPTIONS)
    assert done.returncode == 0, done.stderr
    assert len(done.stdout.splitlines()) == 1 + len(STEPS)
    together = json.loads((tmp_path / "all.json").read_text())["steps"]
    assert [report.pop("step") for report in together] == list(STEPS)
    rows = list(csv.DictReader(open(tmp_path / "steps.csv")))
    for index, (number, report) in enumerate(zip(STEPS, together, strict=True)):
        alone = run("metrics", dump, "--step", number, "--json", tmp_path / "one.json", "--out", tmp_path / "one.h5", *region, *OPTIONS)
        assert alone.returncode == 0, alone.stderr
        assert json.loads((tmp_path / "one.json").read_text()) == report
        mine = {row["key"]: row for row in rows if row["step"] == str(number)}
        assert float(mine["height/Ra"]["value"]) == report["height"]["Ra"]
        assert float(mine["height/Ra"]["upper"]) == report["uncertainty"]["height"]["Ra"]["upper"]
        with h5py.File(tmp_path / "all.h5") as all_steps, h5py.File(tmp_path / "one.h5") as one:
            group = all_steps[f"step_{index:04}"]
            assert group.attrs["step"] == number
            names = []
            one.visititems(lambda name, item: names.append(name) if isinstance(item, h5py.Dataset) else None)
            assert len(names) > 100
            for name in names:
                np.testing.assert_array_equal(group[name][...], one[name][...])
    assert together[0]["height"] != together[2]["height"]


def test_the_frame_is_that_of_the_last_step(run, dump, tmp_path):
    done = run("metrics", dump, "--step", "all", "--json", tmp_path / "all.json", "--quiet", *OPTIONS)
    assert done.returncode == 0 and done.stdout == "", done.stderr
    regions = [report["config"]["x_range"] for report in json.loads((tmp_path / "all.json").read_text())["steps"]]
    run("metrics", dump, "--step", "last", "--json", tmp_path / "last.json", *OPTIONS)
    assert regions == 3 * [json.loads((tmp_path / "last.json").read_text())["config"]["x_range"]]


def test_describe_all(run, dump):
    done = run("describe", dump, "--step", "all", "--json")
    described = json.loads(done.stdout)
    assert [facts["step"] for facts in described] == [str(number) for number in STEPS]
    assert len({facts["mean x [m]"] for facts in described}) == 3
    assert run("describe", dump, "--step", "all").stdout.count("particles            80") == 3


def test_where_all_is_refused(run, dump, tmp_path):
    for arguments, sentence in (
        (["convert", dump, tmp_path / "a.csv", "--step", "all"], "--step: all is for metrics and describe"),
        (["metrics", dump, "--step", "all", "--vtk", tmp_path / "vtk", *OPTIONS], "--vtk: writes one time step"),
        (["metrics", dump, "--step", "some", *OPTIONS], 'no time step; write last, first or its number'),
    ):
        done = run(*arguments)
        assert done.returncode == 2 and sentence in done.stderr and len(done.stderr.splitlines()) == 1, done.stderr
    assert list(tmp_path.iterdir()) == []


def test_a_damaged_later_step_leaves_nothing(run, dump, tmp_path):
    text = dump.read_text()
    bad = tmp_path / "bad.dump"
    bad.write_text(text[: text.rindex("80 ")] + "80 nan 1 0.5 0.5\n")
    done = run("metrics", bad, "--step", "all", "--json", tmp_path / "a.json", "--out", tmp_path / "a.h5", "--csv", tmp_path, *OPTIONS)
    assert done.returncode == 2 and "bad.dump:" in done.stderr
    assert [file.name for file in tmp_path.iterdir()] == ["bad.dump"]
