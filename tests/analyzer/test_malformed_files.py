"""Every way of being damaged, in every format that has it: one sentence that says where, exit code 2, nothing written."""

import re
import sys
from pathlib import Path

import h5py
import numpy as np
import pytest

sys.path.insert(0, str(Path(__file__).parent))
import small_layers

TEXTS = small_layers.texts()
HUGE = 2**60
# Line of the first particle, columns, and the columns of x, y, radius or diameter, id; counted from 0.
TABLES = {
    "csv": (2, ",", 5, {"x": 1, "y": 2, "size": 4, "id": 0}),
    "lammps-dump": (10, " ", 9, {"x": 2, "y": 3, "size": 5, "id": 0}),
    "lammps-data": (12, " ", 10, {"x": 4, "y": 5, "size": 2, "id": 0}),
    "yade-text": (2, "\t", 5, {"x": 1, "y": 2, "size": 4, "id": 0}),
    "mercury-data": (2, " ", 14, {"x": 0, "y": 1, "size": 6}),
    "extended-xyz": (3, " ", 9, {"x": 1, "y": 2, "size": 7, "id": 8}),
}
ROW = 30  # the particle that is damaged


def changed(name, column, value):
    """The text with one cell of particle ROW replaced, and that particle's line."""
    first, separator, _, columns = TABLES[name]
    lines = TEXTS[name].split("\n")
    cells = lines[first - 1 + ROW].split(separator)
    cells[columns[column]] = value
    lines[first - 1 + ROW] = separator.join(cells)
    return "\n".join(lines), first + ROW


def is_at(sentence, line, column):
    return sentence.startswith(f"recoat-analyze: error: layer:{line}: column {column + 1} (")


@pytest.fixture
def refusal(refused, tmp_path):
    """The sentence about these bytes as a file `layer`."""

    def run(content, *options):
        (tmp_path / "layer").write_bytes(content if isinstance(content, bytes) else content.encode())
        sentence = refused("convert", "layer", "out.csv", *options)
        assert sentence.rstrip("\n").isprintable() and len(sentence) < 700
        return sentence

    return run


@pytest.mark.parametrize("name", TEXTS)
def test_whole_files_are_read(good, tmp_path, name):
    """So that what follows fails for its own reason."""
    (tmp_path / "layer").write_text(TEXTS[name])
    good("convert", "layer", "out.csv")
    rows = np.loadtxt(tmp_path / "out.csv", delimiter=",", skiprows=1)
    assert len(rows) == small_layers.COUNT
    assert f'"{name}"' in good("describe", "layer", "--json")


@pytest.mark.parametrize("value", ["nan", "-inf", "1e999", "1.2.3", "0x10", "", "--1", "1e", "\x01\x02", "ä"])
@pytest.mark.parametrize("name", TABLES)
def test_positions_that_are_no_numbers(refusal, name, value):
    if value == "" and TABLES[name][1] == " ":
        value = "?"  # nothing between two blanks is no cell
    text, line = changed(name, "x", value)
    if value == "" and name == "yade-text":
        assert f"layer:{line}: the line has 4 columns" in refusal(text)
    else:
        assert is_at(refusal(text), line, TABLES[name][3]["x"])


@pytest.mark.parametrize("value", ["0", "-2.5e-05", "nan", "inf"])
@pytest.mark.parametrize("name", TABLES)
def test_sizes_not_above_zero(refusal, name, value):
    text, line = changed(name, "size", value)
    assert is_at(refusal(text), line, TABLES[name][3]["size"])


@pytest.mark.parametrize("name", [n for n in TABLES if "id" in TABLES[n][3]])
def test_identities(refusal, name):
    text, line = changed(name, "id", "105")
    sentence = refusal(text)
    assert f"layer:{line}: the id 105 has been given to another particle already (line {line - ROW + 4})" in sentence
    text, line = changed(name, "id", "12.5")
    assert is_at(refusal(text), line, TABLES[name][3]["id"])


@pytest.mark.parametrize("difference", [-1, 1])
@pytest.mark.parametrize("name", TABLES)
def test_wrong_number_of_columns(refusal, name, difference):
    first, separator, columns, _ = TABLES[name]
    lines = TEXTS[name].split("\n")
    cells = lines[first - 1 + ROW].split(separator)
    lines[first - 1 + ROW] = separator.join(cells[:-1] if difference < 0 else [*cells, "0"])
    assert f"layer:{first + ROW}: the line has {columns + difference} columns" in refusal("\n".join(lines))


@pytest.mark.parametrize("name", ["lammps-dump", "lammps-data", "extended-xyz"])
def test_outside_the_box(refusal, name):
    text, line = changed(name, "x", "0.5")
    assert f"layer:{line}: the particle lies at x = 0.5 m, outside the box of the file, 0 ... 0.004 m" in refusal(text)


@pytest.mark.parametrize("name", TEXTS)
def test_cut_within_the_particles(refusal, name):
    """At each of a dozen places. A table has no end of its own: cut behind a line, it is a shorter table."""
    text = TEXTS[name]
    for size in np.linspace(len(text) // 3, len(text) - 8, 12).astype(int):
        if name in ("csv", "yade-text"):
            size = text.rindex("\n", 0, size) + 20  # within a line
        assert "layer:" in refusal(text[:size]), size


@pytest.mark.parametrize(
    ("name", "old", "line"),
    [("lammps-dump", f"ATOMS\n{small_layers.COUNT}\n", 59), ("lammps-data", f"{small_layers.COUNT} atoms", 61),
     ("mercury-data", f"{small_layers.COUNT} 0", 51), ("extended-xyz", f"{small_layers.COUNT}\n", 52), ("legacy-vtk", f"POINTS {small_layers.COUNT}", 5),
     ("vtk-xml", f'NumberOfPoints="{small_layers.COUNT}"', 4)],
)
@pytest.mark.parametrize("count", [HUGE, 3 * 2**61, 2**63, -1, small_layers.COUNT + 1])
def test_counts_that_the_file_cannot_have(refusal, name, old, line, count):
    text = TEXTS[name].replace(old, old.replace(str(small_layers.COUNT), str(count)), 1)
    assert text != TEXTS[name]
    place = int(re.search(r"layer:(\d+):", refusal(text)).group(1))
    assert place <= len(text.splitlines()) + 1
    if count == HUGE:
        assert place == line


@pytest.mark.parametrize("name", TEXTS)
def test_binary_where_numbers_are_expected(refusal, name):
    content = TEXTS[name].encode()
    place = content.index(b"0.00", len(content) // 2)
    for garbage in (bytes(range(128, 160)), bytes(16), b"\xff\xfe" * 8, b"\x1b[31m"):
        assert "layer:" in refusal(content[:place] + garbage + content[place + len(garbage) :])


def test_tilted_boxes(refusal):
    """Tilt factors, or vectors along the edges and the origin behind each of them."""
    tilts = re.sub(r"(?m)^(0\.0 [\d.e-]+)$", r"\1 1e-5", small_layers.dump_head("xy xz yz ff pp ff"))
    assert "layer:6: the box is triclinic (tilted)" in refusal(tilts)
    edges = re.sub(r"(?m)^0\.0 ([\d.e-]+)$", r"\1 \1 \1 0", small_layers.dump_head("abc origin ff pp ff"))
    assert "layer:6: the box is triclinic (tilted)" in refusal(edges)
    data = TEXTS["lammps-data"].replace("\nAtoms", "0 1e-5 0 xy xz yz\n\nAtoms")
    assert "layer:9: the box is triclinic (tilted)" in refusal(data)


def test_units_that_do_not_fit(refusal):
    dump = "ITEM: UNITS\nlj\n" + TEXTS["lammps-dump"]
    assert 'layer:11: the dump has the units "lj", which say no length in metres; give it with --length-unit' in refusal(dump)
    sentence = refusal(dump.replace("lj", "micro"), "--length-unit", "mm")
    assert "layer: the file says itself that its unit of length is 1e-06 m; leave the unit out" in sentence
    assert "--length-unit" in refusal(TEXTS["csv"], "--length-unit", "furlong")
    assert 'layer:1: the unit of the column "x [furlong]" is none of a length' in refusal(TEXTS["csv"].replace(",x,", ",x [furlong],"))


@pytest.mark.parametrize("count", [0, 1, 4096, 1_000_000])
def test_files_of_nothing_but_zeros_or_blanks(refusal, count):
    for byte in (b"\0", b" ", b"\n"):
        assert "layer: " in refusal(byte * count)


@pytest.mark.parametrize("head", ["", "id,x,y,z,radius\n", small_layers.dump_head(), small_layers.data_head(), "#format x_y_z_r\n"])
def test_a_million_lines_of_garbage(refusal, head):
    lines = (head + "fhtagn 12 : 3e4 ,, -- q\n" * 1_000_000).encode()
    assert re.search(r"layer:\d+: ", refusal(lines))


def state_faults():
    """What is done to a state file, and what the sentence says."""

    def array(name, **changes):
        def change(file):
            old = file[name][...]
            del file[name]
            if "value" in changes:
                old[changes.get("row", ROW)] = changes["value"]
                file[name] = old
            else:
                file.create_dataset(name, shape=changes["shape"], dtype=changes.get("type", old.dtype), chunks=changes.get("chunks"))

        return change

    def huge(file):
        file["VTKHDF/NumberOfPoints"][0] = HUGE // 8
        array("VTKHDF/Points", shape=(HUGE // 8, 3), chunks=(8, 3))(file)

    def attribute(group, name, value):
        return lambda file: file[group].attrs.__setitem__(name, value)

    data = "VTKHDF/PointData/"
    return {
        "no_radius": (lambda file: file.__delitem__(data + "Radius"), "Radius: the array is missing"),
        "short_radius": (array(data + "Radius", shape=(3,)), "Radius: the array has too few rows"),
        "no_columns": (array("VTKHDF/Points", shape=(small_layers.COUNT,)), "differ in length"),
        "two_columns": (array("VTKHDF/Points", shape=(small_layers.COUNT, 2)), "differ in length"),
        "nan": (array("VTKHDF/Points", value=np.nan), f"particle {ROW} has the centre"),
        "negative_radius": (array(data + "Radius", value=-1e-5), f"particle {ROW} has the centre"),
        "duplicate": (array(data + "Id", value=105), "the id 105 has been given to another particle already (particle 4)"),
        "huge_array": (huge, "Points: the array says that it is larger than its file can be"),
        "huge_count": (array("VTKHDF/NumberOfPoints", row=0, value=HUGE), "the array has too few rows"),
        "negative_count": (array("VTKHDF/NumberOfPoints", row=0, value=-1), "the array has too few rows"),
        "negative_offset": (array("VTKHDF/Steps/PointOffsets", row=0, value=-5), "the array has too few rows"),
        "text_for_numbers": (array(data + "Radius", shape=(small_layers.COUNT,), type="S4"), "Radius"),
        "steps": (attribute("VTKHDF/Steps", "NSteps", np.int64(HUGE)), "the array has too few rows"),
        "no_steps": (attribute("VTKHDF/Steps", "NSteps", np.int64(0)), "no state"),
        "negative_steps": (attribute("VTKHDF/Steps", "NSteps", np.int64(-3)), "the array has too few rows"),
        "version": (attribute("recoat", "schema_version", np.int64(99)), "schema version 99"),
        "kind": (attribute("recoat", "seed", np.array([1, 2])), "attribute seed: it holds another kind of value"),
    }


@pytest.mark.parametrize("fault", state_faults())
def test_states(good, refused, tmp_path, fault):
    (tmp_path / "table.csv").write_text(TEXTS["csv"])
    good("convert", "table.csv", "layer.vtkhdf")
    change, expected = state_faults()[fault]
    with h5py.File(tmp_path / "layer.vtkhdf", "r+") as file:
        change(file)
    sentence = refused("convert", "layer.vtkhdf", "out.csv")
    assert "layer.vtkhdf" in sentence and expected in sentence


@pytest.mark.parametrize("share", [0.02, 0.3, 0.6, 0.99])
def test_cut_hdf5_files(good, refused, tmp_path, share):
    (tmp_path / "table.csv").write_text(TEXTS["csv"])
    good("convert", "table.csv", "whole.vtkhdf")
    small_layers.write_vtkhdf(tmp_path / "foreign.vtkhdf")
    for whole in ("whole.vtkhdf", "foreign.vtkhdf"):
        content = (tmp_path / whole).read_bytes()
        (tmp_path / "layer").write_bytes(content[: int(share * len(content))])
        assert "layer" in refused("convert", "layer", "out.csv")
