"""Random starts of a case, the same for both codes."""

import csv
from math import pi

import numpy as np


def random_column(case, packing_density, seed):
    """Centres of spheres of diameter 1 in a column on z = 0, without overlaps, periodic in y; array (particles, 3) [d_p].

    One after the other at random places; the column is as high as the packing density says.
    """
    random = np.random.default_rng(seed)
    (lower, upper), width, count = case["column"], case["width"], case["particles"]
    height = count * pi / 6 / (packing_density * (upper - lower) * width)
    low, high = np.array([lower + 0.5, 0.0, 0.5]), np.array([upper - 0.5, width, 0.5 + height])
    placed = np.empty((0, 3))
    while len(placed) < count:
        candidate = random.uniform(low, high)
        apart = placed - candidate
        apart[:, 1] -= width * np.round(apart[:, 1] / width)
        if np.all((apart**2).sum(axis=1) > 1.0):
            placed = np.vstack([placed, candidate])
    return placed


def write_table(file, points, radius):
    """The particles at rest as recoat-solve reads them; points and radius in metres."""
    with open(file, "w", newline="") as stream:
        rows = csv.writer(stream)
        rows.writerow(["x", "y", "z", "radius"])
        rows.writerows([*(repr(float(value)) for value in point), radius] for point in points)


def write_data(file, points, radius, density, ends, width, top):
    """The same as a data file of LAMMPS; all lengths in metres."""
    with open(file, "w") as stream:
        stream.write(f"random start\n\n{len(points)} atoms\n1 atom types\n\n{ends[0]!r} {ends[1]!r} xlo xhi\n")
        stream.write(f"0 {width!r} ylo yhi\n0 {top!r} zlo zhi\n\nAtoms # sphere\n\n")
        for i, point in enumerate(points, 1):
            stream.write(f"{i} 1 {2 * radius!r} {density!r} {' '.join(repr(float(value)) for value in point)}\n")
