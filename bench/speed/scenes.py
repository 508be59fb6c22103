"""The scenes that are stepped: bench/scenes with their particles from bench/data, in one folder."""

import csv
import gzip
import shutil
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
COLUMNS = ("x", "y", "z", "radius", "vx", "vy", "vz", "wx", "wy", "wz")

# Table of particles of each scene: file in bench/data, copies side by side along y, period there [m].
TABLES = {
    "bed": ("settled-bed.csv.gz", 1, 1e-3),
    "large_bed": ("settled-bed.csv.gz", 10, 1e-3),
    "heap": ("heap.csv.gz", 1, 1e-3),
}


def read_particles(scene):
    """Rows of numbers in the order of COLUMNS; what the file leaves out is zero."""
    name, copies, period = TABLES[scene]
    with gzip.open(ROOT / "bench/data" / name, "rt") as stream:
        rows = [[float(value) for value in row] for row in list(csv.reader(stream))[1:]]
    rows = [row + [0.0] * (len(COLUMNS) - len(row)) for row in rows]
    return [[row[0], row[1] + copy * period, *row[2:]] for copy in range(copies) for row in rows]


def prepare(folder, scenes=tuple(TABLES)):
    """Writes scenes and their tables into `folder` unless they are there; returns the scene files by name."""
    folder = Path(folder)
    folder.mkdir(parents=True, exist_ok=True)
    files = {}
    for scene in scenes:
        table = folder / f"{scene}.csv"
        source = ROOT / "bench/data" / TABLES[scene][0]
        if not table.exists() or table.stat().st_mtime < source.stat().st_mtime:
            lines = [",".join(COLUMNS)] + [",".join(f"{value:.12g}" for value in row) for row in read_particles(scene)]
            unfinished = table.with_suffix(".part")
            unfinished.write_text("\n".join(lines) + "\n")
            unfinished.rename(table)
        files[scene] = Path(shutil.copy(ROOT / "bench/scenes" / f"{scene}.yaml", folder))
    return files
