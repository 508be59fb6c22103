"""Particle states in the VTKHDF PolyData layout, as recoat-solve writes them."""

from dataclasses import dataclass, field

import h5py
import numpy
import yaml

from reporting import Implausible

METRES = {"nm": 1e-9, "um": 1e-6, "mm": 1e-3, "cm": 1e-2, "m": 1.0}


@dataclass
class State:
    """One time step: arrays over the particles, in SI units, and the attributes of the file's /recoat group."""

    path: str
    points: numpy.ndarray
    data: dict
    info: dict = field(default_factory=dict)

    @property
    def diameter(self):
        """Particle diameter d_p [m]."""
        return float(self.info["diameter"])

    @property
    def radius(self):
        """Radius of every particle [m]."""
        return self.data["Radius"]


def read_state(path, step=-1):
    """One time step of a state file, by default the last."""
    with h5py.File(path) as file:
        root = file["VTKHDF"]
        steps = root["Steps"]
        first = int(steps["PointOffsets"][step])
        count = int(root["NumberOfPoints"][step])
        points = root["Points"][first : first + count]
        data = {}
        for name, values in root["PointData"].items():
            begin = int(steps["PointDataOffsets"][name][step])
            data[name] = values[begin : begin + count]
        info = {name: text(value) for name, value in file["recoat"].attrs.items()}
    return State(str(path), points, data, info)


def times(path):
    """Of the time steps of a state file [s]."""
    with h5py.File(path) as file:
        return file["VTKHDF/Steps/Values"][:]


def read_walls(path, time):
    """Walls and blade of a wall file at its last step that is not after a time [s]: (number of the wall, corners [m])."""
    with h5py.File(path) as file:
        root = file["VTKHDF"]
        steps = root["Steps"]
        step = max(int(numpy.searchsorted(steps["Values"][:], time * (1 + 1e-9), side="right")) - 1, 0)
        # Part 2 of vertices, lines, polygons and strips; each step's list of cells begins with a zero.
        cells, first = int(root["Polygons/NumberOfCells"][step]), int(steps["CellOffsets"][step][2])
        ends = root["Polygons/Offsets"][first + step : first + step + cells + 1]
        begin, points = int(steps["ConnectivityIdOffsets"][step][2]), int(steps["PointOffsets"][step])
        members = root["Polygons/Connectivity"][begin : begin + int(ends[-1])]
        corners = root["Points"][points : points + int(root["NumberOfPoints"][step])]
        number = int(steps["CellDataOffsets/Wall"][step])
        walls = root["CellData/Wall"][number : number + cells]
    return [(int(walls[k]), corners[members[ends[k] : ends[k + 1]]]) for k in range(cells)]


def text(value):
    """HDF5 strings come as bytes."""
    return value.decode() if isinstance(value, bytes) else value


def length(quantity, diameter):
    """A length of a resolved scene, such as "4 dp" or "50 um", in metres."""
    number, _, unit = str(quantity).strip().partition(" ")
    metres = diameter if unit == "dp" else METRES.get(unit)
    if metres is None:
        raise Implausible(f'"{quantity}" is not a length: give a number and one of dp, nm, um, mm, cm, m')
    return float(number) * metres


def fill_box(state):
    """x of the faces of blade and gate between which the particles were filled in [m]."""
    scene = yaml.safe_load(state.info["config"])
    thickness = length(scene["blade"]["thickness"], state.diameter)
    lower = float(state.info["blade_start"]) + thickness
    return lower, lower + length(scene["box"]["fill_length"], state.diameter)
