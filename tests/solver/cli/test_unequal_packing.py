"""Packing density and contacts of unequal spheres, from the solver's fill through the analyser, against numpy."""

import json
import math
import subprocess

import h5py
import numpy as np
import pytest
from scipy import stats

DP, CLEARANCE, PERIOD, X0, X1 = 50e-6, 100e-6, 300e-6, 300e-6, 550e-6
SIZES = {"median": 55e-6, "deviation": 1.25, "smallest": 30e-6, "largest": 75e-6}  # log-normal by mass

FILL = """
powder:
  particles: 200
  sizes: {distribution: log_normal, weighting: mass, median: 55 um, geometric_deviation: 1.25, smallest: 30 um,
          largest: 75 um}
box: {length: 30 dp, width: 6 dp, fill_length: 7 dp}
blade: {clearance: 2 dp, speed: 100 mm/s}
stages:
  - fill: {settle_time: 10 ms}
"""


class Bed:
    """Spheres of a state, and the images of each across the period."""

    def __init__(self, state):
        with h5py.File(state) as file:
            self.centre = file["VTKHDF/Points"][()]
            self.radius = file["VTKHDF/PointData/Radius"][()]
            self.coordination = file["VTKHDF/PointData/CoordinationNumber"][()]
        self.inside = (self.centre[:, 0] >= X0) & (self.centre[:, 0] < X1)

    def touching(self, factor):
        """[N, N] whether two spheres are nearer than factor (r_i + r_j), by every distance."""
        apart = self.centre[:, None] - self.centre[None]
        apart[:, :, 1] -= PERIOD * np.round(apart[:, :, 1] / PERIOD)
        touch = np.linalg.norm(apart, axis=2) <= factor * (self.radius[:, None] + self.radius[None])
        np.fill_diagonal(touch, False)
        return touch

    def solid(self, low, high):
        """Volume of the spheres, with their images, in the box from `low` to `high` [m3]."""
        images = np.concatenate([self.centre + [0, shift * PERIOD, 0] for shift in (-1, 0, 1)])
        return sum(
            volume_in_box(centre, radius, low, high) for centre, radius in zip(images, np.tile(self.radius, 3))
        )


def volume_in_box(centre, radius, low, high, points=200):
    """Volume of a sphere in a box: whole, none, or columns along y over points of x and z, cut where the box ends."""
    low, high = low - centre, high - centre
    if np.any(low >= radius) or np.any(high <= -radius):
        return 0.0
    if np.all(low <= -radius) and np.all(high >= radius):
        return 4 / 3 * math.pi * radius**3
    a, b = np.maximum(low, -radius), np.minimum(high, radius)
    x, z = (a[k] + (b[k] - a[k]) * (np.arange(points) + 0.5) / points for k in (0, 2))
    half = np.sqrt(np.maximum(0, radius**2 - x[:, None] ** 2 - z[None] ** 2))
    length = np.maximum(0, np.minimum(high[1], half) - np.maximum(low[1], -half))
    return length.mean() * (b[0] - a[0]) * (b[2] - a[2])


def slab(centre, radius, low, high):
    """Volume of a sphere between two planes of x: pi (r^2 u - u^3/3)."""
    u = [np.clip(x - centre, -radius, radius) for x in (low, high)]
    return math.pi * (radius**2 * (u[1] - u[0]) - (u[1] ** 3 - u[0] ** 3) / 3)


@pytest.fixture(scope="module")
def folder(build, model, tmp_path_factory):
    """A filled column of 200 spheres, log-normal by mass."""
    folder = tmp_path_factory.mktemp("packing")
    finer = model.replace("time_step: 1e-7 s", "time_step: 5e-8 s") + "seed: 3\ncohesion: {bond_number: 20}\n"
    (folder / "fill.yaml").write_text("scene: spread\n" + finer + FILL)
    words = [build / "solver/recoat-solve", "run", "fill.yaml", "--out", "out", "--threads", "1", "--quiet"]
    done = subprocess.run(words, cwd=folder, capture_output=True, text=True, timeout=120, check=False)
    assert done.returncode == 0, done.stderr
    return folder


@pytest.fixture(scope="module")
def bed(folder):
    return Bed(folder / "out/fill.vtkhdf")


@pytest.fixture(scope="module", params=[1.0, 1.005])
def report(build, folder, request):
    words = [build / "analyzer/recoat-analyze", "metrics", "out/fill.vtkhdf", "--json", "report.json", "--quiet"]
    for setting in ("x_range=[6 dp, 11 dp]", "contact_mode=radii", f"contact_factor={request.param}", "voxels_per_dp=[]"):
        words += ["--set", setting]
    done = subprocess.run(words, cwd=folder, capture_output=True, text=True, timeout=120, check=False)
    assert done.returncode == 0, done.stderr
    return json.loads((folder / "report.json").read_text())


def test_the_sizes_follow_the_law(bed):
    width = math.log(SIZES["deviation"])
    by_number = SIZES["median"] * math.exp(-3 * width**2)  # Hatch and Choate
    law = stats.lognorm(width, scale=by_number)
    low, high = law.cdf([SIZES["smallest"], SIZES["largest"]])
    distance = stats.kstest(2 * bed.radius, lambda d: (law.cdf(d) - low) / (high - low)).statistic
    assert distance < 1.36 / math.sqrt(len(bed.radius))  # passed by chance in 1 of 20; the seed is fixed
    by_mass = stats.lognorm(width, scale=SIZES["median"])
    assert stats.kstest(2 * bed.radius, by_mass.cdf).statistic > 1.36 / math.sqrt(len(bed.radius))


def test_coordination_numbers_are_those_of_every_distance(report, bed):
    touch = bed.touching(report["config"]["contact_factor"])
    numbers = touch.sum(axis=1)
    assert bed.inside.sum() > 100 and 2 < numbers[bed.inside].mean() < 7
    clusters = report["clusters"]
    assert clusters["n_contacts"] == touch.sum() // 2
    assert clusters["n_particles"] == bed.inside.sum()
    assert clusters["cn_mean"] == pytest.approx(numbers[bed.inside].mean(), rel=1e-14)
    assert report["particles"]["cn"] == numbers.tolist()
    counts = np.bincount(numbers[bed.inside])
    assert clusters["cn_counts"][: len(counts)] == counts.tolist()


def test_the_state_has_the_coordination_numbers_of_the_paper(bed):
    assert np.array_equal(bed.coordination, bed.touching(1.005).sum(axis=1))


def test_packing_density_is_that_of_clipped_spheres(report, bed):
    found = np.array(report["maps"]["phi_exact"])
    assert found.shape == (5, 6)
    expected = np.empty_like(found)
    for i, j in np.ndindex(found.shape):
        middle = np.array([X0 + (i + 0.5) * DP, (j + 0.5) * DP])
        low, high = np.append(middle - 1.5 * DP, 0), np.append(middle + 1.5 * DP, CLEARANCE)
        expected[i, j] = bed.solid(low, high) / np.prod(high - low)
    assert 0.25 < expected.min() < expected.max() < 0.7
    assert found == pytest.approx(expected, abs=2e-5)
    assert report["phi_exact"]["mean"] == pytest.approx(expected.mean(), abs=1e-5)
    assert report["phi_exact"]["median"] == pytest.approx(np.median(expected), abs=2e-5)


def test_totals_are_those_of_all_spheres(report, bed):
    whole = 4 / 3 * math.pi * np.sum(bed.radius[bed.inside] ** 3)
    clipped = np.sum(slab(bed.centre[:, 0], bed.radius, X0, X1))
    assert abs(clipped / whole - 1) > 1e-4
    totals, area = report["totals"], (X1 - X0) * PERIOD
    assert totals["volume_whole_m3"] == pytest.approx(whole, rel=1e-12)
    assert totals["volume_clipped_m3"] == pytest.approx(clipped, rel=1e-9)
    assert totals["mass_per_area"] == pytest.approx(4430 * whole / area, rel=1e-12)
    assert totals["layer_phi"] == pytest.approx(clipped / (area * CLEARANCE), rel=1e-9)
