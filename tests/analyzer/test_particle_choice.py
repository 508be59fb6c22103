"""Which particles of a file are taken, and what is left out of them: by type, of size zero, without velocities."""

import json
import sys
from pathlib import Path

import h5py
import numpy as np
import pytest

sys.path.insert(0, str(Path(__file__).parent))
import small_layers

REPORTS = Path(__file__).resolve().parents[1] / "data/reports"
BOX = "0 0.004\n0 0.001\n-6e-05 0.002"
HEAD = f"ITEM: TIMESTEP\n{{step}}\nITEM: NUMBER OF ATOMS\n{{count}}\nITEM: BOX BOUNDS ff pp ff\n{BOX}\nITEM: ATOMS id type x y z radius vx vy vz\n"


def described(good, *arguments):
    return json.loads(good("describe", *arguments, "--json"))


def typed(template):
    """Rows of the small layer, every third of type 2."""
    lines = small_layers.rows(template).splitlines()
    return "\n".join(line.replace("TYPE", "2" if i % 3 == 0 else "1") for i, line in enumerate(lines)) + "\n"


def of_vtk():
    types = " ".join("2" if i % 3 == 0 else "1" for i in range(small_layers.COUNT))
    return small_layers.xml().replace(
        "<PointData>\n", f'<PointData>\n<DataArray type="Float64" Name="Material" format="ascii">{types}</DataArray>\n'
    )


TYPED = {
    "lammps-dump": small_layers.dump_head() + typed("{id} TYPE {x} {y} {z} {r} {vx} {vy} {vz}"),
    "lammps-data": small_layers.data_head() + typed("{id} TYPE {d} 2500 {x} {y} {z} 0 0 0"),
    "csv": "id,type,x,y,z,radius\n" + typed("{id},TYPE,{x},{y},{z},{r}"),
    "yade-text": "#format x_y_z_r_matId\n" + typed("{x}\t{y}\t{z}\t{r}\tTYPE"),
    "mercury-data": small_layers.texts()["mercury-data"].splitlines()[0] + "\n" + typed("{x} {y} {z} 0 0 0 {r} 0 0 0 0 0 0 TYPE"),
    "extended-xyz": f"{small_layers.COUNT}\nProperties=species:S:1:pos:R:3:radius:R:1\n" + typed("TYPE {x} {y} {z} {r}"),
    "vtk-xml": of_vtk(),
}


@pytest.mark.parametrize("name", TYPED)
def test_types_in_every_format(good, refused, tmp_path, name):
    (tmp_path / "layer").write_text(TYPED[name])
    second = -(-small_layers.COUNT // 3)
    assert described(good, "layer")["format"] == name
    assert described(good, "layer", "--type", "2")["particles"] == second
    assert described(good, "layer", "--without-type", "2")["particles"] == small_layers.COUNT - second
    assert described(good, "layer", "--type", "1,2")["particles"] == small_layers.COUNT
    assert 'layer: no particle is of the type "3"; the types are: 2, 1' in refused("describe", "layer", "--without-type", "3")


def test_a_plate_is_left_out(good, tmp_path):
    """The layer is measured as if the frozen spheres of the plate below it were not in the file."""
    generator = np.random.default_rng(3)
    powder = [(2, x, y, 2.5e-5, 2.5e-5) for x, y in generator.uniform([0, 0], [4e-3, 1e-3], (200, 2))]
    plate = [(1, x, y, -3e-5, 3e-5) for x in np.arange(3e-5, 4e-3, 6e-5) for y in np.arange(3e-5, 1e-3, 6e-5)]
    for name, spheres in (("both", plate + powder), ("alone", powder)):
        rows = "".join(f"{i} {t} {float(x)!r} {float(y)!r} {z!r} {r!r} 0 0 0\n" for i, (t, x, y, z, r) in enumerate(spheres))
        (tmp_path / name).write_text(HEAD.format(step=0, count=len(spheres)) + rows)
    options = ["--set", "h_b=75um", "--set", "density=4430", "--set", "voxels_per_dp=[]", "--quiet"]
    good("metrics", "both", "--without-type", "1", "--json", "both.json", *options)
    good("metrics", "both", "--type", "2", "--json", "only.json", *options)
    good("metrics", "alone", "--json", "alone.json", *options)
    both, only, alone = (json.loads((tmp_path / f"{name}.json").read_text()) for name in ("both", "only", "alone"))
    assert both["totals"]["layer_phi"] > 0
    assert both == only == alone


def test_a_radius_for_each_type(good, refused, tmp_path):
    layer = REPORTS / "a22_two_sizes_by_type.dump"
    good("convert", layer, "out.csv", "--radius", "1=25um, 2=15um")
    assert np.loadtxt(tmp_path / "out.csv", delimiter=",", skiprows=1)[:, 5].tolist() == [2.5e-5, 1.5e-5, 2.5e-5]
    assert 'gives no radius for the type "2"; the types are: 1, 2' in refused("describe", layer, "--radius", "1=25um")
    assert described(good, layer, "--radius", "1=25um", "--type", "1")["radius [m]"] == [2.5e-5, 2.5e-5]
    assert '--radius: "15um" is not TYPE=RADIUS' in refused("describe", layer, "--radius", "1=25um,15um")
    assert '--radius: "0" is not above zero' in refused("describe", layer, "--radius", "1=25um,2=0")


def test_a_column_of_another_name(good, refused, tmp_path):
    (tmp_path / "layer").write_text("x,y,z,r,phase\n1,1,1,1,a\n3,1,1,1,b\n")
    assert described(good, "layer", "--type-column", "phase", "--type", "b")["x [m]"] == [3, 3]
    assert "layer: the file gives no types of its particles" in refused("describe", "layer", "--type", "b")
    assert 'there is no column "kind" among those of the file (x, y, z, r, phase)' in refused("describe", "layer", "--type-column", "kind")


@pytest.mark.parametrize("name", TYPED)
def test_particles_of_size_zero(analyze, refused, tmp_path, name):
    """Some programs fill their arrays with such placeholders."""
    text = TYPED[name]
    radius = repr(float(small_layers.particles()[1][0] * (2 if name == "lammps-data" else 1)))
    (tmp_path / "layer").write_text(text.replace(radius, "0", 1))
    assert "--skip-size-zero" in refused("describe", "layer")
    done = analyze("describe", "layer", "--skip-size-zero", "--json")
    assert json.loads(done.stdout)["particles"] == small_layers.COUNT - 1
    assert "1 of 50 particles are left out, for they have the size 0" in done.stderr


def test_types_are_described(analyze, good, tmp_path):
    (tmp_path / "layer").write_text(TYPED["lammps-dump"])
    facts = json.loads(good("describe", "layer", "--json"))
    kinds = [part.split(" (")[0] for part in facts["types"].split(", ")]
    assert len(kinds) > 1 and sum(int(part.split("(")[1][:-1]) for part in facts["types"].split(", ")) == small_layers.COUNT
    alone = json.loads(good("describe", "layer", "--json", "--type", kinds[0]))
    assert alone["types"] == facts["types"].split(", ")[0]
    done = analyze("describe", "layer", "--without-type", ",".join(kinds))
    assert done.returncode == 0 and "the choice of types leaves no particle; the types are: 2, 1" in done.stderr


@pytest.mark.parametrize("value", ["nan", "-nan", "inf"])
@pytest.mark.parametrize("name", ["lammps-dump", "csv", "mercury-data", "extended-xyz", "vtk-xml", "vtkhdf"])
def test_velocities_that_are_unknown(analyze, tmp_path, name, value):
    """No metric needs them: the layer is read, without."""
    if name == "vtkhdf":
        small_layers.write_vtkhdf(tmp_path / "layer")
        with h5py.File(tmp_path / "layer", "r+") as file:
            file["VTKHDF/PointData/velocity"][7, 1] = float(value)
    elif name == "vtk-xml":
        values = "1 2 3 " * (small_layers.COUNT - 1) + f"0 {value} 0"
        array = f'<DataArray type="Float64" Name="v" NumberOfComponents="3" format="ascii">{values}</DataArray>\n'
        (tmp_path / "layer").write_text(small_layers.xml().replace("<PointData>\n", "<PointData>\n" + array))
    else:
        head, row = {
            "lammps-dump": (small_layers.dump_head(), "{id} 1 {x} {y} {z} {r} {vx} VY {vz}"),
            "csv": ("id,x,y,z,r,vx,vy,vz\n", "{id},{x},{y},{z},{r},{vx},VY,{vz}"),
            "mercury-data": (TYPED["mercury-data"].splitlines()[0] + "\n", "{x} {y} {z} {vx} VY {vz} {r} 0 0 0 0 0 0 0"),
            "extended-xyz": (f"{small_layers.COUNT}\nProperties=id:I:1:pos:R:3:radius:R:1:vel:R:3\n", "{id} {x} {y} {z} {r} {vx} VY {vz}"),
        }[name]
        (tmp_path / "layer").write_text(head + small_layers.rows(row).replace("VY", value, 1).replace("VY", "0"))
    done = analyze("convert", "layer", "out.csv")
    assert done.returncode == 0 and "the velocity of this particle is not finite; it is left out for all" in done.stderr
    assert "vx" not in (tmp_path / "out.csv").read_text()
