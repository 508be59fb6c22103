"""What `make bench` gives to LIGGGHTS and LAMMPS; the programs themselves are run where they are installed."""

import math
import re

import pytest


@pytest.fixture(scope="module")
def peers(speed):
    return speed("peers")


def least_force(force, least=1e-13, largest=1e-7, steps=20_000):
    """The most negative of forces at overlaps evenly spread in logarithm [N]."""
    return min(force(least * (largest / least) ** (k / steps)) for k in range(steps + 1))


@pytest.mark.parametrize("bond", [50, 400])
def test_sjkr_pulls_off_at_the_bond_number(peers, bond):
    stiffness, radius = peers.MODULUS / (2 * (1 - peers.POISSON**2)), peers.DIAMETER / 2
    density = peers.cohesion_energy_density(bond)

    def net(overlap):
        lens = math.pi * (radius**2 - (radius - overlap / 2) ** 2)
        return 4 / 3 * stiffness * math.sqrt(radius / 2) * overlap**1.5 - density * lens

    assert -least_force(net) == pytest.approx(bond * peers.weight(), rel=2e-3)


def test_dmt_pulls_off_at_the_bond_number(peers):
    reduced_radius = peers.DIAMETER / 4
    assert 4 * math.pi * peers.surface_energy(50) * reduced_radius == pytest.approx(50 * 2.844e-9, rel=1e-3)
    assert peers.surface_energy(0) == 0 and peers.cohesion_energy_density(0) == 0


def test_geometry_follows_the_scene(speed, peers, tmp_path):
    files = speed("scenes").prepare(tmp_path, ["bed", "heap", "layer"])
    assert peers.geometry(files["bed"])[:3] == pytest.approx((0, 1e-3, 1e-3)) and peers.geometry(files["bed"])[3] is None
    assert peers.geometry(files["heap"]) == pytest.approx((-5e-4, 8e-3, 1e-3, 1e-3))
    assert peers.geometry(files["layer"])[:3] == pytest.approx((-5e-5, 3.13e-2, 2e-3))


def test_data_files_have_every_particle_between_the_walls(speed, peers, tmp_path):
    files = speed("scenes").prepare(tmp_path, ["heap"])
    assert peers.write_data("heap", files["heap"], tmp_path / "heap.data") == 10_000
    text = (tmp_path / "heap.data").read_text()
    lower, upper = map(float, re.search(r"(\S+) (\S+) xlo xhi", text).groups())
    atoms = [line.split() for line in text.split("Atoms\n\n")[1].split("\n\nVelocities")[0].splitlines()]
    assert len(atoms) == 10_000 and all(lower < float(atom[4]) < upper for atom in atoms)
    assert {float(atom[2]) for atom in atoms} == {5e-5} and {float(atom[3]) for atom in atoms} == {4430}


def test_the_blade_is_a_closed_section(peers, tmp_path):
    peers.write_blade(1e-3, 1e-3, tmp_path / "blade.stl")
    vertices = [tuple(map(float, line.split()[1:])) for line in (tmp_path / "blade.stl").read_text().splitlines() if line.startswith("vertex")]
    assert len(vertices) == 24
    assert {x for x, _, _ in vertices} == {8e-4, 1e-3} and min(z for *_, z in vertices) == pytest.approx(7.5e-5)


def test_each_style_knows_what_it_cannot_do(speed, peers, tmp_path):
    files = speed("scenes").prepare(tmp_path, ["bed"])
    assert peers.Peers(tmp_path, files).rate("LAMMPS hertz", ("bed", 50, 1), 1, 1, 1e-6) is None


@pytest.mark.parametrize("name", ["LIGGGHTS", "LAMMPS granular", "LAMMPS hertz, omp"])
def test_a_peer_that_is_here_sees_the_same_contacts(speed, peers, tmp_path, name):
    if peers.program(name) is None:
        pytest.skip(f"{name} is not installed; make bench does it")
    files = speed("scenes").prepare(tmp_path, ["layer"])
    result = peers.Peers(tmp_path, files).rate(name, ("layer", 0, 1), 2, 3, 1e-6)
    assert result["rate"] > 0 and result["particles"] == 10_000
    assert result["coordination"] == pytest.approx(0.05, abs=0.005)
    assert result["kinetic_energy"] == pytest.approx(9.0e-14, rel=0.05)


class FakePeers:
    """Rates by skin; one of them fails."""

    def __init__(self):
        self.asked = []

    def rate(self, name, case, warm, steps, skin, timeout=600):
        self.asked.append((name, case, skin))
        if skin == 1e-6:
            raise RuntimeError("lost atoms")
        return {"rate": {2e-6: 3.0, 3e-6: 2.0}[skin]}


def test_the_fastest_skin_is_taken_and_tried_once(speed, tmp_path):
    fake, steps = FakePeers(), {"bed": {"peers": {"warm": 1, "steps": 2}}}
    journal = speed("journal").Journal(tmp_path / "journal.jsonl")
    granular = speed("contenders").Peer("LAMMPS granular", fake, steps, (1e-6, 2e-6, 3e-6), "LAMMPS hertz", journal)
    assert granular.skin("bed") == 2e-6 and granular.skin("bed") == 2e-6
    assert fake.asked == [("LAMMPS hertz", ("bed", 0, 1), skin) for skin in (1e-6, 2e-6, 3e-6)]


def test_skins_that_all_fail_are_told(speed, tmp_path):
    journal = speed("journal").Journal(tmp_path / "journal.jsonl")
    peer = speed("contenders").Peer("LIGGGHTS", FakePeers(), {"bed": {"peers": {"warm": 1, "steps": 2}}}, (1e-6,), "LIGGGHTS", journal)
    with pytest.raises(RuntimeError, match="lost atoms"):
        peer.skin("bed")
