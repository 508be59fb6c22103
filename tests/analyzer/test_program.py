"""The command line of recoat-analyze."""

import json
import subprocess
from pathlib import Path

import pytest

CASES = Path(__file__).resolve().parents[1] / "data/cases"
LAYER, CONFIG = CASES / "polydisperse.csv", CASES / "polydisperse.cfg.json"


@pytest.fixture
def analyze(build, tmp_path):
    """Runs the program in an empty folder."""

    def run(*arguments):
        command = [build / "analyzer/recoat-analyze", *map(str, arguments)]
        return subprocess.run(command, cwd=tmp_path, capture_output=True, text=True, check=False)

    return run


def test_results_do_not_depend_on_the_threads(analyze, tmp_path):
    for threads in (1, 2, 3):
        done = analyze("metrics", LAYER, "--config", CONFIG, "--json", f"{threads}.json", "--out", f"{threads}.h5", "--threads", threads)
        assert done.returncode == 0, done.stderr
    for ending in ("json", "h5"):
        one = (tmp_path / f"1.{ending}").read_bytes()
        assert (tmp_path / f"2.{ending}").read_bytes() == one
        assert (tmp_path / f"3.{ending}").read_bytes() == one


def test_set_replaces_values(analyze, tmp_path):
    def config_with(*settings):
        arguments = [word for setting in settings for word in ("--set", setting)]
        done = analyze("metrics", LAYER, "--config", CONFIG, "--json", "out.json", *arguments)
        assert done.returncode == 0, done.stderr
        return json.loads((tmp_path / "out.json").read_text())

    report = config_with("phi_x_edge=interior", "voxels_per_dp=[4]", "h_b=100 um", "x_range=[0, 0.5 mm]")
    assert report["config"]["h_b"] == pytest.approx(1e-4)
    assert list(report["voxel"]) == ["4"]
    assert len(report["maps"]["height"]) == 10
    assert len(report["maps"]["phi_exact"]) == 8
    assert report["phi_exact"]["n"] == 96


def test_summary_names_the_region(analyze):
    done = analyze("metrics", LAYER, "--config", CONFIG)
    assert "x = 0 ... 0.001 m (20 d_p)" in done.stdout
    assert "149 in the region, 220 in the file" in done.stdout
    assert analyze("metrics", LAYER, "--config", CONFIG, "--quiet").stdout == ""


def test_describe(analyze):
    done = analyze("describe", LAYER, "--json")
    assert done.returncode == 0
    facts = json.loads(done.stdout)
    assert facts["format"] == "csv"
    assert facts["particles"] == 220
    assert facts["radius [m]"][1] == 3.75e-5
    assert facts["d_p [m]"] is None
    text = analyze("describe", LAYER).stdout
    assert "particles            220" in text
    empty = analyze("describe", CASES / "empty.csv", "--json")
    assert json.loads(empty.stdout)["x [m]"] is None


def refused(done, tmp_path):
    """The sentence of a refusal, which leaves nothing behind."""
    assert done.returncode == 2, done.stderr
    lines = done.stderr.splitlines()
    assert len(lines) == 1
    left = {file.name for file in tmp_path.iterdir()} - {"bad.csv", "bad.yaml"}
    assert left == set()
    return lines[0]


@pytest.mark.parametrize(
    ("text", "sentence"),
    [
        ("", "bad.csv: the file is empty"),
        ("x,y,z,radius\n1e-4,1e-4,nan,2e-5\n", "bad.csv:2: column 3 (z): \"nan\": the number is not finite"),
        ("x,y,z,radius\n1e-4,1e-4,1e-5,-2e-5\n", "bad.csv:2: column 4 (radius): \"-2e-5\": a particle must have a size above zero"),
        ("x,y,z,radius\n1e-4,1e-4,1e-5\n", "bad.csv:2: the line has 3 columns, the first line names 4"),
        ("x,y,z,radius,x\n", "bad.csv:1: the column \"x\" is named twice"),
        ("x,y,z,radius\n1,2,3,4\n", "particle 0 lies "),
        ("\0\1\2", "bad.csv: the format is not known"),
    ],
)
def test_bad_layers_are_refused(analyze, tmp_path, text, sentence):
    (tmp_path / "bad.csv").write_text(text)
    done = analyze("metrics", "bad.csv", "--config", CONFIG, "--json", "out.json", "--out", "out.h5")
    assert sentence in refused(done, tmp_path)


@pytest.mark.parametrize(
    ("text", "sentence"),
    [
        ("d_p: 50 um\ngird: 1\n", "bad.yaml:1: h_b: the file of particles does not say the clearance under the blade; give it"),
        ("d_p: 50 kg\n", "bad.yaml:1: d_p"),
        ("d_p: 50 um\ndensity: 4430\nh_b: 75 um\nx_range: [0, 1 mm]\ny_min: 0\ny_period: 0.6 mm\ngird: 1\n", "bad.yaml:7: gird"),
        ("d_p: 50 um\ndensity: 4430\nh_b: 75 um\nx_range: [0, 1.01 mm]\ny_min: 0\ny_period: 0.6 mm\ngrid: 1 dp\n", "bad.yaml:4: x_range: the region is 20.2 cells"),
    ],
)
def test_bad_configurations_are_refused(analyze, tmp_path, text, sentence):
    (tmp_path / "bad.yaml").write_text(text)
    done = analyze("metrics", LAYER, "--config", "bad.yaml", "--json", "out.json", "--out", "out.h5")
    assert sentence in refused(done, tmp_path)


def test_bad_commands_are_refused(analyze, tmp_path):
    assert "--config" in refused(analyze("metrics", LAYER), tmp_path)
    assert "subcommand" in refused(analyze(), tmp_path)
    assert "--set z_bin=1 kg" in refused(analyze("metrics", LAYER, "--config", CONFIG, "--json", "a.json", "--set", "z_bin=1 kg"), tmp_path)
    assert "threads" in refused(analyze("metrics", LAYER, "--config", CONFIG, "--threads", "0"), tmp_path)


def test_version_and_help(analyze):
    assert analyze("--version").stdout.startswith("recoat-analyze 0.")
    assert "describe" in analyze("--help").stdout
