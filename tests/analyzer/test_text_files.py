"""What happens to files of text on their way: encodings, lost ends, comments, identities, names of columns."""

import re
import sys
from pathlib import Path

import h5py
import numpy as np
import pytest

sys.path.insert(0, str(Path(__file__).parent))
import small_layers

TEXTS = small_layers.texts()
ENDED = [name for name in TEXTS if name not in ("csv", "vtk-xml")]  # every writer of these ends every line
LARGE = 2**60


def table_of(good, tmp_path, *arguments):
    good("convert", *arguments, "table.csv")
    with open(tmp_path / "table.csv") as file:
        names = file.readline().strip().split(",")
        return names, [line.split(",") for line in file.read().splitlines()]


@pytest.mark.parametrize("name", TEXTS)
def test_a_byte_order_mark_and_line_ends_of_windows(good, tmp_path, name):
    (tmp_path / "plain").write_text(TEXTS[name])
    expected = table_of(good, tmp_path, "plain")
    (tmp_path / "marked").write_bytes(b"\xef\xbb\xbf" + TEXTS[name].encode())
    assert table_of(good, tmp_path, "marked") == expected
    (tmp_path / "windows").write_bytes(TEXTS[name].replace("\n", "\r\n").encode())
    assert table_of(good, tmp_path, "windows") == expected


@pytest.mark.parametrize("encoding", ["utf-16", "utf-16-le", "utf-16-be", "utf-32"])
@pytest.mark.parametrize("name", TEXTS)
def test_wide_encodings_are_named(refused, tmp_path, name, encoding):
    (tmp_path / "layer").write_bytes(TEXTS[name].encode(encoding))
    sentence = refused("describe", "layer")
    assert f"layer: the file is text in {encoding[:6].upper()}" in sentence and "UTF-8" in sentence


@pytest.mark.parametrize("cut", [1, 2])
@pytest.mark.parametrize("name", ENDED)
def test_files_that_end_inside_a_line(refused, tmp_path, name, cut):
    """Behind the last number or inside it."""
    (tmp_path / "layer").write_text(TEXTS[name][:-cut])
    line = TEXTS[name].count("\n")
    assert re.search(rf"layer:{line}: .*(ends inside this line|columns)", refused("convert", "layer", "out.csv"))


def test_a_table_without_a_last_line_end_is_read_with_a_warning(analyze, tmp_path):
    (tmp_path / "layer").write_text(TEXTS["csv"][:-1])
    done = analyze("describe", "layer")
    assert done.returncode == 0
    assert f"layer:{small_layers.COUNT + 1}: the last line has no line end" in done.stderr


@pytest.mark.parametrize("ending", ["csv", "vtp", "dump", "vtkhdf", "xyz"])
def test_identities_keep_64_bits(good, tmp_path, ending):
    """From every format that is written, and from arrays of VTKHDF as another code writes them."""
    (tmp_path / "layer.csv").write_text(re.sub(r"(?m)^1(\d\d),", lambda row: f"{LARGE + int(row[1])},", TEXTS["csv"]))
    names, rows = table_of(good, tmp_path, "layer.csv")
    assert [int(row[names.index("id")]) for row in rows] == [LARGE + i for i in range(1, small_layers.COUNT + 1)]
    good("convert", "layer.csv", f"other.{ending}")
    again, others = table_of(good, tmp_path, f"other.{ending}")
    assert [dict(zip(again, row))["id"] for row in others] == [row[0] for row in rows]


def test_identities_of_foreign_vtkhdf_keep_64_bits(good, tmp_path):
    small_layers.write_vtkhdf(tmp_path / "foreign.vtkhdf")
    with h5py.File(tmp_path / "foreign.vtkhdf", "r+") as file:
        ids = file["VTKHDF/PointData/id"][...].astype(np.int64) + LARGE
        del file["VTKHDF/PointData/id"]
        file["VTKHDF/PointData/id"] = ids
    names, rows = table_of(good, tmp_path, "foreign.vtkhdf")
    assert [int(row[names.index("id")]) for row in rows] == ids.tolist()


@pytest.mark.parametrize("command", ["describe", "convert"])
def test_columns_by_the_names_of_the_file(good, refused, tmp_path, command):
    text = TEXTS["csv"].replace("id,x,y,z,radius", "id,East (mm),North (mm),Up (mm),Grain (mm)")
    (tmp_path / "layer").write_text(text)
    names = ["columns.x=East (mm)", "columns.y=North", "columns.z=Up (mm)", "columns.radius=grain (mm)"]
    out = ["out.csv"] if command == "convert" else []
    settings = [word for name in names for word in ("--set", name)]
    good(command, "layer", *out, *settings)
    (tmp_path / "out.csv").unlink(missing_ok=True)
    sentence = refused(command, "layer", *out, *settings[2:])
    assert '"x" among those of the file (id, east (mm), north (mm), up (mm), grain (mm))' in sentence
    assert "--set columns.x=NAME" in sentence
    assert "voxels" in refused(command, "layer", *out, "--set", "voxels=3")


def test_a_time_step_without_particles_is_named(analyze, refused, tmp_path):
    empty = small_layers.dump_head().replace("STEP\n7\n", "STEP\n8\n").replace(f"ATOMS\n{small_layers.COUNT}\n", "ATOMS\n0\n")
    values = ["--set", "h_b=75um", "--set", "density=4430"]
    (tmp_path / "layer").write_text(TEXTS["lammps-dump"] + empty)
    assert "layer: the time step 8 has no particles; choose another with --step" in refused("metrics", "layer", *values)
    done = analyze("metrics", "layer", *values, "--step", "all")
    assert "layer: the time step 8 has no particles; it is passed over" in done.stderr
    (tmp_path / "table").write_text("x,y,z,radius\n")
    assert "table: the file has no particles" in refused("metrics", "table", *values)


def test_edem_exports(good, refused, tmp_path):
    points, radii, _, ids = small_layers.particles()
    rows = {"Particle ID": ids, "Position X (mm)": points[:, 0] * 1e3, "Position Y (mm)": points[:, 1] * 1e3}
    rows |= {"Position Z (mm)": points[:, 2] * 1e3, "Particle Radius (mm)": radii * 1e3}
    lines = [f"Q{i:02} : {name}:,{','.join(map(repr, values.tolist()))}" for i, (name, values) in enumerate(rows.items(), 1)]
    text = "EXTRACTED DATA FROM LAYER.dem\nTIME: 0.5\nQ00 : Total Number of Particles:,50\n" + "\n".join(lines) + "\n"
    (tmp_path / "layer").write_text(text)
    names, table = table_of(good, tmp_path, "layer")
    values = np.array(table, float)
    assert names == ["id", "x", "y", "z", "radius"] and (values[:, 0] == ids).all()
    np.testing.assert_allclose(values[:, 1:4], points, rtol=1e-15)
    np.testing.assert_allclose(values[:, 4], radii, rtol=1e-15)
    (tmp_path / "layer").write_text(text.replace(repr(float(radii[-1] * 1e3)) + "\n", "\n").replace(",\n", "\n"))
    assert 'layer:8: the query "particle radius (mm)" has 49 values, but others have 50' in refused("describe", "layer")
