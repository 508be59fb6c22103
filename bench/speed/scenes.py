"""The scenes that are stepped: bench/scenes with their particles from bench/data, in one folder."""

import csv
import gzip
from dataclasses import dataclass
from pathlib import Path

import yaml

ROOT = Path(__file__).resolve().parents[2]
COLUMNS = ("x", "y", "z", "radius", "vx", "vy", "vz", "wx", "wy", "wz")


@dataclass(frozen=True)
class Source:
    """Where a scene comes from: a file of bench/scenes and a table of bench/data, and what is changed in them."""

    scene: str
    table: str
    copies: int = 1  # side by side along y
    period: float = 1e-3  # of one copy in y [m]
    unequal: bool = False  # radii differ, by too little to matter
    without: tuple = ()  # keys that are left out of the scene
    changes: tuple = ()  # pairs of keys and values


SOURCES = {
    "bed": Source("bed", "settled-bed"),
    "large_bed": Source("bed", "settled-bed", copies=10, changes=(("y_period", "200 dp"),)),
    "heap": Source("heap", "heap"),
    "layer": Source("layer", "layer", period=2e-3),
    "bed_unequal": Source("bed", "settled-bed", unequal=True),
    "bed_without_walls": Source("bed", "settled-bed", without=("walls",), changes=(("gravity", "0 m/s2"),)),
}


def read_particles(scene):
    """Rows of numbers in the order of COLUMNS; what the file leaves out is zero."""
    source = SOURCES[scene]
    with gzip.open(ROOT / f"bench/data/{source.table}.csv.gz", "rt") as stream:
        rows = [[float(value) for value in row] for row in list(csv.reader(stream))[1:]]
    rows = [row + [0.0] * (len(COLUMNS) - len(row)) for row in rows]
    if source.unequal:
        rows = [[*row[:3], row[3] * (1 - 1e-9 * (i % 2)), *row[4:]] for i, row in enumerate(rows)]
    return [[row[0], row[1] + copy * source.period, *row[2:]] for copy in range(source.copies) for row in rows]


def scene_text(scene):
    """The scene file, with its table beside it."""
    source = SOURCES[scene]
    content = yaml.safe_load((ROOT / f"bench/scenes/{source.scene}.yaml").read_text())
    content |= {"particles": f"{scene}.csv", **dict(source.changes)}
    return yaml.safe_dump({key: value for key, value in content.items() if key not in source.without}, sort_keys=False, default_flow_style=None)


def prepare(folder, scenes=tuple(SOURCES)):
    """Writes scenes and their tables into `folder` unless they are there; returns the scene files by name."""
    folder = Path(folder).resolve()
    folder.mkdir(parents=True, exist_ok=True)
    for scene in scenes:
        table, source = folder / f"{scene}.csv", ROOT / f"bench/data/{SOURCES[scene].table}.csv.gz"
        if not table.exists() or table.stat().st_mtime < source.stat().st_mtime:
            lines = [",".join(COLUMNS)] + [",".join(f"{value:.15g}" for value in row) for row in read_particles(scene)]
            unfinished = table.with_suffix(".part")
            unfinished.write_text("\n".join(lines) + "\n")
            unfinished.rename(table)
        (folder / f"{scene}.yaml").write_text(scene_text(scene))
    return {scene: folder / f"{scene}.yaml" for scene in scenes}
