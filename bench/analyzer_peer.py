"""The metrics of a layer with numpy, scipy and PoreSpy, each part timed: prints one JSON object.

usage: analyzer_peer.py LAYER.csv LENGTH WIDTH [n ...]   (d_p = 50 um, h_b = 1.5 d_p; LENGTH and WIDTH in d_p)
"""

import json
import sys
import time

import numpy as np
import porespy
import scipy.ndimage
import scipy.sparse.csgraph
import scipy.spatial

porespy.settings.tqdm["disable"] = True
DIAMETER, CLEARANCE = 5e-5, 1.5


class Clock:
    def __init__(self):
        self.seconds, self.values = {}, {}

    def time(self, name, work):
        wall, cpu = time.perf_counter(), time.process_time()
        result = work()
        self.seconds[name] = {"wall": time.perf_counter() - wall, "cpu": time.process_time() - cpu}
        return result


def contacts(centres, width):
    """Pairs nearer than 1.005 d_p, periodic along y; coordination numbers."""
    tree = scipy.spatial.cKDTree(centres, boxsize=[0, width, 0])
    pairs = tree.query_pairs(1.005, output_type="ndarray")
    return pairs, np.bincount(pairs.ravel(), minlength=len(centres))


def clusters(pairs, count):
    graph = scipy.sparse.coo_matrix((np.ones(len(pairs)), pairs.T), shape=(count, count))
    labels = scipy.sparse.csgraph.connected_components(graph, directed=False)[1]
    return np.bincount(labels)


def circumcircles(points):
    """Centres and radii of the Delaunay triangles without an obtuse angle."""
    corners = points[scipy.spatial.Delaunay(points).simplices]
    a, b = corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]
    twice = 2 * (a[:, 0] * b[:, 1] - a[:, 1] * b[:, 0])
    aa, bb = (a**2).sum(axis=1), (b**2).sum(axis=1)
    arm = np.stack([b[:, 1] * aa - a[:, 1] * bb, a[:, 0] * bb - b[:, 0] * aa], axis=1) / twice[:, None]
    right = np.sum(a * b, axis=1) >= 0
    for one, other in ((-a, b - a), (-b, a - b)):
        right &= np.sum(one * other, axis=1) >= 0
    return (corners[:, 0] + arm)[right], np.sqrt((arm**2).sum(axis=1))[right]


def chambers(centres, width):
    """Rule A: from large to small, centre in none taken before; the numbers of all maxima and of those taken."""
    plane = centres[:, :2]
    tiled = np.concatenate([plane + [0, shift] for shift in (-width, 0, width)])
    tiled = tiled[(tiled[:, 1] > -width / 2) & (tiled[:, 1] < 1.5 * width)]
    places, radii = circumcircles(tiled)
    inside = (places[:, 1] >= 0) & (places[:, 1] < width) & (radii > 0.5)
    places, radii = places[inside], radii[inside] - 0.5
    order = np.argsort(-radii)
    places, radii = places[order], radii[order]
    tree = scipy.spatial.cKDTree(places, boxsize=[0, width])
    free = np.ones(len(radii), dtype=bool)
    for k in range(len(radii)):
        if free[k]:
            near = tree.query_ball_point(places[k], radii[k] * (1 - 1e-12))
            free[[j for j in near if j > k]] = False
    return places[free], radii[free]


def voxel_maps(centres, radii, length, width, n):
    """Packing density over 3 x 3 d_p and highest voxel over 1 x 1 d_p, at the cell centres."""
    layers = int(np.ceil(np.max(centres[:, 2] + radii) * n))
    margin = n
    solid = np.zeros((int(length * n) + 2 * margin, int(width * n), layers), dtype=bool)
    for (x, y, z), r in zip(centres, radii):
        i = np.arange(max(int((x - r) * n), -margin), min(int((x + r) * n) + 1, solid.shape[0] - margin))
        j = np.arange(int(np.floor((y - r) * n)), int((y + r) * n) + 1)
        k = np.arange(max(int((z - r) * n), 0), min(int((z + r) * n) + 1, layers))
        dx, dy, dz = ((c + 0.5) / n - p for c, p in ((i, x), (j, y), (k, z)))
        ball = dx[:, None, None] ** 2 + dy[None, :, None] ** 2 + dz[None, None, :] ** 2 <= r * r
        place = np.ix_(i + margin, j % solid.shape[1], k)
        solid[place] |= ball
    below = solid[:, :, : int(CLEARANCE * n)].sum(axis=2)
    cells = below.reshape(solid.shape[0] // n, n, solid.shape[1] // n, n).sum(axis=(1, 3))
    windows = sum(np.roll(cells, step, axis=1) for step in (-1, 0, 1))
    phi = (windows[:-2] + windows[1:-1] + windows[2:]) / (9 * n * n * int(CLEARANCE * n))
    top = np.where(solid.any(axis=2), layers - np.argmax(solid[:, :, ::-1], axis=2), 0)[margin:-margin]
    height = top.reshape(int(length), n, int(width), n).max(axis=(1, 3)) / n
    return phi, height


def top_view(centres, radii, length, width, n):
    """Pixels that are free, with half a period more on both sides along y."""
    free = np.ones((int(length * n), int(width * n)), dtype=bool)
    for (x, y, _), r in zip(centres, radii):
        i = np.arange(max(int((x - r) * n), 0), min(int((x + r) * n) + 1, free.shape[0]))
        j = np.arange(int(np.floor((y - r) * n)), int((y + r) * n) + 1)
        disk = ((i + 0.5) / n - x)[:, None] ** 2 + ((j + 0.5) / n - y)[None, :] ** 2 <= r * r
        free[np.ix_(i, j % free.shape[1])] &= ~disk
    half = free.shape[1] // 2
    return np.concatenate([free[:, -half:], free, free[:, :half]], axis=1)


def porespy_peaks(distance):
    peaks = porespy.filters.find_peaks(distance, r_max=3)
    return porespy.filters.trim_nearby_peaks(peaks, distance, f=1)


def main():
    file, length, width, *resolutions = sys.argv[1], float(sys.argv[2]), float(sys.argv[3]), *map(int, sys.argv[4:])
    table = np.loadtxt(file, delimiter=",", skiprows=1) / DIAMETER
    centres, radii = table[:, :3], table[:, 3]
    clock = Clock()
    pairs, numbers = clock.time("contacts", lambda: contacts(centres, width))
    sizes = clock.time("clusters", lambda: clusters(pairs, len(centres)))
    clock.values |= {"contacts": len(pairs), "cn_mean": float(numbers.mean()), "clusters": int((sizes > 1).sum())}
    if radii.max() - radii.min() < 1e-9:
        taken = clock.time("chamber pores, rule A", lambda: chambers(centres, width))[1]
        clock.values["chambers A, D >= 0.5"] = int((2 * taken >= 0.5).sum())
    for n in resolutions:
        phi, height = clock.time(f"voxel maps {n}", lambda n=n: voxel_maps(centres, radii, length, width, n))
        clock.values[f"voxel median phi {n}"] = float(np.median(phi))
        clock.values[f"voxel mean height {n}"] = float(height.mean())
        free = clock.time(f"pixels {n}", lambda n=n: top_view(centres, radii, length, width, n))
        distance = clock.time(f"scipy distance transform {n}", lambda free=free: scipy.ndimage.distance_transform_edt(free))
        peaks = clock.time(f"PoreSpy peaks {n}", lambda distance=distance: porespy_peaks(distance))
        half = int(width * n) // 2
        clock.values[f"PoreSpy peaks {n}, D >= 0.5"] = int(scipy.ndimage.label(peaks[:, half:-half] & (2 * distance[:, half:-half] >= 0.5 * n))[1])
    print(json.dumps({"seconds": clock.seconds, "values": clock.values}))


main()
