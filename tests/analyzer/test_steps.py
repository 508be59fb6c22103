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
        (["convert", dump, tmp_path / "a.csv", "--step", "all"], "a.csv: a file of the format csv holds one time step"),
        (["convergence", dump, "--step", "all", *OPTIONS], "--step: all is for metrics, describe and convert"),
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


def test_whole_steps_before_a_damaged_one(run, dump, tmp_path):
    """A run that is still writing, or was stopped: what it wrote whole can be read."""
    text, bad = dump.read_text(), tmp_path / "bad.dump"
    for cut in (text.rindex("ITEM: ATOMS") + 60, text.rindex("ITEM: BOX") + 3, text.rindex("ITEM: TIMESTEP") + 16):
        bad.write_text(text[:cut])
        for choice in ("first", "100", "250"):
            done = run("describe", bad, "--step", choice, "--json")
            assert done.returncode == 0, done.stderr
            assert json.loads(done.stdout)["step"] == ("100" if choice == "first" else choice)
        for arguments in (["describe", bad], ["describe", bad, "--step", "all"], ["metrics", bad, "--step", "all", *OPTIONS],
                          ["convert", bad, tmp_path / "out.xyz", "--step", "all"]):
            done = run(*arguments)
            assert done.returncode == 2 and done.stdout == "" and "bad.dump:" in done.stderr
            assert done.stderr.rstrip().endswith("2 time steps (100, 250), which --step 250 reads"), done.stderr
    bad.write_text(text[: text.rindex("ITEM: ATOMS") + 60])
    assert "time step 900" in run("describe", bad).stderr
    bad.write_text(text[:100])
    assert "bad.dump:" in run("describe", bad, "--step", "first").stderr


@pytest.mark.parametrize(
    ("numbers", "chosen", "warning"),
    [
        ([100, 250, 250, 900], "last", "the time step 250 is there twice (places 2 and 3 of 4 in the file); taken is the step 900 at place 4"),
        ([100, 250, 250, 900], "250", "taken is the step 250 at place 3, one of 2 of this number"),
        ([0, 500, 0, 100], "last", "the counter of time steps goes back from 500 to 0 (places 2 and 3 of 4 in the file); taken is the step 100 at place 4"),
        ([0, 500, 0, 100], "0", "taken is the step 0 at place 3, one of 2 of this number"),
        ([0, 500, 0, 100], "first", "taken is the step 0 at place 1, one of 2 of this number"),
        ([0, 500, 0, 100], "all", "all are taken, in the order of the file"),
        ([0, 100, 500], "last", None),
    ],
)
@pytest.mark.parametrize("form", ["dump", "xyz"])
def test_steps_out_of_order(run, dump, tmp_path, form, numbers, chosen, warning):
    """A run that was continued into the same file, with its counter or without."""
    first = dump.read_text().split("ITEM: TIMESTEP")[1]
    if form == "dump":
        text = "".join("ITEM: TIMESTEP" + first.replace("100", str(n), 1).replace("\n1 ", f"\n{5000 + place} ", 1) for place, n in enumerate(numbers))
    else:
        text = "".join(f"1\nTimestep={n} Properties=id:I:1:pos:R:3:radius:R:1\n{5000 + place} 1 1 1 0.5\n" for place, n in enumerate(numbers))
    (tmp_path / "layer").write_text(text)
    done = run("describe", tmp_path / "layer", "--step", chosen)
    assert done.returncode == 0, done.stderr
    if warning is None:
        assert done.stderr == ""
        return
    assert warning in done.stderr and len(done.stderr.splitlines()) == 1
    if chosen != "all":
        run("convert", tmp_path / "layer", tmp_path / "out.csv", "--step", chosen)
        place = int(warning.split("at place ")[1].split(",")[0])
        assert f"\n{4999 + place}," in (tmp_path / "out.csv").read_text()


def test_numbers_of_steps_as_reals(run, dump, tmp_path):
    (tmp_path / "layer").write_text(dump.read_text().replace("TIMESTEP\n900", "TIMESTEP\n9e+02"))
    assert json.loads(run("describe", tmp_path / "layer", "--step", "900", "--json").stdout)["step"] == "900"
    (tmp_path / "layer").write_text(dump.read_text().replace("TIMESTEP\n900", "TIMESTEP\n900.5"))
    assert "is no number of a time step" in run("describe", tmp_path / "layer").stderr
