"""Reference numbers of the analytic tests, from closed forms and adaptive integration.

Shares no code with the solver. `python reference.py` prints the table that the tests read, `reference.json`. SI units.
"""

import json
from dataclasses import dataclass

import numpy as np
from scipy.integrate import quad
from scipy.optimize import brentq

from friction import Friction, damping
from impacts import normal_impact, pair_impact, wall_impact
from pull_off import pull_off_load

GRAVITY = 9.81
RADIUS, DENSITY, YOUNG, POISSON = 25e-6, 4430.0, 110e9, 0.3
SLIDING, ROLLING, RESTITUTION = 0.3, 0.01, 0.4
NEAR, FAR = 1.65e-10, 1e-7  # limits of the attraction
BONDS = (1, 5, 50, 200, 400)
MASS = 4 / 3 * np.pi * RADIUS**3 * DENSITY
PAIR, WALL = 0.5, 1.0  # reduced mass and radius over those of one sphere
LARGE = 10 / 11  # reduced radius with a sphere of ten times the radius


def stiffness(young, poisson, reduced_radius, rigid=False):
    """k of F = k d^1.5: like materials, or a sphere on a rigid body."""
    modulus = young / (1 - poisson**2) / (1 if rigid else 2)
    return 4 / 3 * modulus * np.sqrt(reduced_radius)


@dataclass
class Cohesive:
    """A pair or a sphere on a wall, at its original stiffness; the paper's powder unless another is given."""

    bond: float
    share: float
    radius: float = RADIUS
    density: float = DENSITY
    young: float = YOUNG
    poisson: float = POISSON
    restitution: float = RESTITUTION
    near: float = NEAR
    far: float = FAR

    @property
    def sphere_mass(self):
        return 4 / 3 * np.pi * self.radius**3 * self.density

    @property
    def mass(self):
        return self.share * self.sphere_mass

    @property
    def force(self):
        """Largest attraction: Bo weights for a pair, twice that on a wall."""
        return 2 * self.share * self.bond * self.sphere_mass * GRAVITY

    def well(self, s):
        """Work of the attraction from s to where it ends, out of contact."""
        far = max(s, self.near)
        return self.force * (self.near**2 * (1 / far - 1 / self.far) + (far - s))

    @property
    def stiffness(self):
        return stiffness(self.young, self.poisson, self.share * self.radius)

    def contact(self, entry):
        """Speed at the end of the overlap, and its duration, after an impact that first touches at `entry`."""
        length = (self.mass * entry**2 / self.stiffness) ** 0.4
        out, duration, _ = normal_impact(damping(self.restitution), self.force / (self.stiffness * length**1.5))
        return entry * out, duration * length / entry

    def excess(self, entry):
        """Square of the speed far away after an impact that first touches at the speed `entry`; < 0: captured."""
        return self.contact(entry)[0] ** 2 - 2 * self.well(0) / self.mass

    def rebound(self, speed):
        return np.sqrt(self.excess(np.sqrt(speed**2 + 2 * self.well(0) / self.mass)))

    def capture(self):
        escape = np.sqrt(2 * self.well(0) / self.mass)
        fast = 2 * escape
        while self.excess(fast) < 0:
            fast *= 2
        entry = brentq(self.excess, 1.0001 * escape, fast, xtol=1e-18, rtol=1e-12)
        return np.sqrt(entry**2 - escape**2)

    def release(self, start):
        """Time to touch from rest at separation `start`, and the speed then."""

        def speed(s):
            return np.sqrt(2 * (self.well(s) - self.well(start)) / self.mass)

        # s = start - p^2 takes the square root out of the start; the kink of the force at NEAR splits the path.
        ends = np.sqrt([0, start - self.near, start])
        legs = [quad(lambda p: 2 * p / speed(start - p * p), a, b, epsrel=1e-11)[0] for a, b in zip(ends, ends[1:])]
        return sum(legs), speed(0.0)


def restitution(table):
    elastic = normal_impact(0.0)
    for e in (0.1, 0.2, 0.4, 0.6, 0.8, 0.9):
        out, duration, overlap = normal_impact(damping(e))
        table[f"restitution.{e}.out"] = out
        table[f"restitution.{e}.duration"] = duration / elastic[1]
        table[f"restitution.{e}.overlap"] = overlap / elastic[2]
        table[f"restitution.{e}.clipped"] = normal_impact(damping(e), clip=True)[0]
        table[f"restitution.{e}.needed"] = brentq(
            lambda alpha, wanted=e: normal_impact(alpha, clip=True)[0] - wanted, damping(e), 3.0, rtol=1e-11
        )


def elastic_impacts(table):
    """Chung & Ooi tests 1 (pairs) and 2 (rigid walls)."""
    cases = {
        "glass": (0.01, 4.8e10, 0.2, 2800, 20.0, PAIR),
        "limestone": (0.01, 2e10, 0.25, 2500, 20.0, PAIR),
        "aluminium": (0.1, 7e10, 0.3, 2699, 0.2, WALL),
        "magnesium": (0.1, 4e10, 0.35, 1800, 0.2, WALL),
    }
    _, duration, overlap = normal_impact(0.0)
    for name, (radius, young, poisson, density, speed, share) in cases.items():
        mass = share * 4 / 3 * np.pi * radius**3 * density
        k = stiffness(young, poisson, share * radius, rigid=share == WALL)
        length = (mass * speed**2 / k) ** 0.4
        table[f"elastic.{name}.overlap"] = overlap * length
        table[f"elastic.{name}.force"] = k * (overlap * length) ** 1.5
        table[f"elastic.{name}.duration"] = duration * length / speed


def cohesion(table):
    for bond in BONDS:
        for name, share in (("pair", PAIR), ("wall", WALL)):
            case = Cohesive(bond, share)
            capture = case.capture()
            table[f"capture.{name}.{bond}"] = capture
            table[f"equilibrium.{name}.{bond}"] = (case.force / case.stiffness) ** (2 / 3)
            if bond in (5, 50, 400):
                for factor in (1.05, 1.5, 2, 5):
                    table[f"rebound.{name}.{bond}.{factor}"] = case.rebound(factor * capture)
                table[f"rebound.{name}.{bond}.fast"] = case.rebound(0.05)
                table[f"touch.{name}.{bond}.duration"] = case.contact(0.05)[1]
    for entry in (0.01, 0.05, 0.5):
        out, duration = Cohesive(400, PAIR).contact(entry)
        table[f"contact.{entry}.out"], table[f"contact.{entry}.duration"] = out, duration
    table["release.time"], table["release.speed"] = Cohesive(400, PAIR).release(3e-10)
    table["weight.overlap"] = (MASS * GRAVITY / stiffness(YOUNG, POISSON, RADIUS)) ** (2 / 3)


def pull_off(table):
    """One sphere moves, its partner is held; the load rises to twice the attraction in 4 ms."""
    for bond in (5, 50, 400):
        for name, share in (("pair", PAIR), ("large", LARGE), ("wall", WALL)):
            case = Cohesive(bond, share)
            table[f"pull_off.{name}.{bond}"] = pull_off_load(
                case.force / MASS, case.stiffness / MASS, NEAR, FAR, damping(RESTITUTION), 4e-3, 20 * NEAR
            )


def stop(table, name, load):
    """Slides, then rolls to rest on a wall from 0.05 m/s under the force `load` per mass; ways in diameters."""
    speed, d = 0.05, 2 * RADIUS
    time = speed / (load * (3.5 * SLIDING - 2.5 * ROLLING))  # surface speed lost per time while it slides
    slow = speed - SLIDING * load * time
    brake = 5 / 7 * ROLLING * load
    table[f"{name}.roll_start"] = (speed**2 - slow**2) / (2 * SLIDING * load) / d
    table[f"{name}.distance"] = table[f"{name}.roll_start"] + slow**2 / (2 * brake) / d
    table[f"{name}.slip_time"], table[f"{name}.time"] = time, time + slow / brake
    table[f"{name}.pure_rolling"] = speed**2 / (2 * brake) / d


def stop_distances(table):
    for bond in (0, *BONDS):
        stop(table, f"stop.{bond}", GRAVITY * (1 + 2 * bond))
    for bond in BONDS:  # a wall with half the Hamaker constant holds as a particle does
        stop(table, f"stop_half.{bond}", GRAVITY * (1 + bond))
    for pull in (19, 99, 199):  # lifted by so many weights
        stop(table, f"stop_lifted.{pull}", GRAVITY * (2 * 400 - pull))


def oblique_walls(table):
    """Chung & Ooi tests 4 (angle), 5 and 6 (tangential over normal speed), and the paper's powder."""
    oxide = Friction(0.092, 0.23, 0.98)
    for angle in (5, 10, 15, 20, 25, 30, 40, 60, 80):
        tangent = np.tan(np.radians(angle))
        out, spin = wall_impact(oxide, tangent)
        table[f"oxide.{angle}.restitution"] = out / tangent
        table[f"oxide.{angle}.spin"] = spin * 3.9 * np.cos(np.radians(angle)) / 2.5e-3
        table[f"oxide.{angle}.rebound"] = np.degrees(np.arctan((out + spin) / 0.98))
    for name, poisson in (("steel", 0.3), ("polyethylene", 0.4)):
        for x in (0.6764, 1, 1.68, 2, 3, 4, 5, 6, 7, 10, 13):
            out, spin = wall_impact(Friction(0.3, poisson, 1.0), 0.3 * x)
            table[f"{name}.{x}.recoil"], table[f"{name}.{x}.spin"] = (out + spin) / 0.3, spin / 0.3
    for name, poisson in (("alloy", 0.33), ("nylon", 0.4)):
        for x in (0.26795, 0.57735, 1, 1.42815, 1.73205, 2.14451, 2.74748, 3.73205, 5.67128):
            out, spin = wall_impact(Friction(0.4, poisson, 0.5), 0.0, x)
            table[f"{name}.{x}.recoil"] = (out + spin) / 0.5
    for damped in (True, False):
        powder = Friction(SLIDING, POISSON, RESTITUTION, damped)
        for x in (0.1, 0.3, 0.5, 1, 2):
            out, spin = wall_impact(powder, x)
            name = f"powder.{'damped' if damped else 'undamped'}.{x}"
            table[f"{name}.recoil"], table[f"{name}.impulse"] = out + spin, out - x


def oblique_pairs(table):
    """Two spheres of the paper's powder at +-0.05 m/s, the second `offset` diameters above the first."""
    for ratio in (1, 0.001):
        for offset in (0.1, 0.5, 0.9):
            normal = 0.1 * np.sqrt(1 - offset**2)
            length = (PAIR * MASS * normal**2 / stiffness(ratio * YOUNG, POISSON, PAIR * RADIUS)) ** 0.4
            friction = Friction(SLIDING, POISSON, RESTITUTION)
            velocity, spin, time, momentum = pair_impact(friction, offset, 2 * RADIUS / length)
            assert abs(momentum - 1) < 1e-9
            name = f"oblique.{ratio}.{offset}"
            table[f"{name}.x"], table[f"{name}.y"] = -0.5 * normal * velocity
            table[f"{name}.spin"] = spin * normal / (2 * RADIUS)
            table[f"{name}.duration"] = time * length / normal
            momentum = pair_impact(friction, offset, 2 * RADIUS / length, radius_arm=True)[3]
            table[f"{name}.radius_arm"] = momentum - 1  # relative change of the angular momentum


def reference_table():
    """Every reference number by name."""
    table = {}
    for fill in (restitution, elastic_impacts, cohesion, pull_off, stop_distances, oblique_walls, oblique_pairs):
        fill(table)
    return {name: float(f"{value:.10g}") for name, value in table.items()}


if __name__ == "__main__":
    print(json.dumps(reference_table(), indent=1))
