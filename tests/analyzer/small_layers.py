"""One small layer of random particles as a file of every format, to be damaged by tests."""

import h5py
import numpy as np

COUNT = 50
BOX = [(0.0, 4e-3), (0.0, 1e-3), (0.0, 5e-4)]


def particles():
    """Positions [m], radii, velocities, identities; every number is short."""
    generator = np.random.default_rng(11)
    low, high = np.array(BOX).T
    points = np.round(generator.uniform(low, high, (COUNT, 3)), 7)
    radii = np.round(generator.uniform(2e-5, 3e-5, COUNT), 7)
    return points, radii, np.round(generator.normal(0, 0.1, (COUNT, 3)), 3), np.arange(COUNT) + 101


def rows(template):
    """Lines of the particles; the template names x, y, z, r, d, vx, vy, vz, id, nl (the number from 1)."""
    lines = []
    for number, (p, r, v, i) in enumerate(zip(*particles()), 1):
        cells = dict(zip(("x", "y", "z"), map(repr, p.tolist())), r=repr(float(r)), d=repr(2 * float(r)), id=i, n=number)
        cells |= dict(zip(("vx", "vy", "vz"), map(repr, v.tolist())))
        lines.append(template.format(**cells))
    return "\n".join(lines) + "\n"


def dump_head(bounds="ff pp ff"):
    box = "".join(f"{low!r} {high!r}\n" for low, high in BOX)
    return f"ITEM: TIMESTEP\n7\nITEM: NUMBER OF ATOMS\n{COUNT}\nITEM: BOX BOUNDS {bounds}\n{box}ITEM: ATOMS id type x y z radius vx vy vz\n"


def data_head():
    box = "".join(f"{low!r} {high!r} {a}lo {a}hi\n" for (low, high), a in zip(BOX, "xyz"))
    return f"LAMMPS data file\n\n{COUNT} atoms\n1 atom types\n\n{box}\nAtoms # sphere\n\n"


def xyz_head():
    lattice = " ".join(repr(BOX[i][1]) if i == j else "0" for i in range(3) for j in range(3))
    return f'{COUNT}\nLattice="{lattice}" pbc="F T F" Properties=species:S:1:pos:R:3:velo:R:3:radius:R:1:id:I:1\n'


def column(values):
    return "\n".join(map(repr, np.asarray(values).tolist())) + "\n"


def points_text():
    return "\n".join(" ".join(map(repr, p)) for p in particles()[0].tolist()) + "\n"


def legacy():
    _, radii, _, ids = particles()
    head = f"# vtk DataFile Version 3.0\nlayer\nASCII\nDATASET POLYDATA\nPOINTS {COUNT} double\n"
    fields = f"POINT_DATA {COUNT}\nFIELD FieldData 2\nradius 1 {COUNT} double\n{column(radii)}id 1 {COUNT} int\n{column(ids)}"
    return head + points_text() + fields


def xml():
    _, radii, _, ids = particles()
    array = '<DataArray type="Float64" Name="{}" NumberOfComponents="{}" format="ascii">\n{}</DataArray>\n'
    data = array.format("radius", 1, column(radii)) + array.format("id", 1, column(ids))
    return (
        f'<?xml version="1.0"?>\n<VTKFile type="PolyData" version="1.0">\n<PolyData>\n<Piece NumberOfPoints="{COUNT}">\n'
        f'<Points>\n{array.format("Points", 3, points_text())}</Points>\n<PointData>\n{data}</PointData>\n'
        "</Piece>\n</PolyData>\n</VTKFile>\n"
    )


def texts():
    """Content by name of the format."""
    box = " ".join(repr(low) for low, _ in BOX) + " " + " ".join(repr(high) for _, high in BOX)
    return {
        "csv": "id,x,y,z,radius\n" + rows("{id},{x},{y},{z},{r}"),
        "lammps-dump": dump_head() + rows("{id} 1 {x} {y} {z} {r} {vx} {vy} {vz}"),
        "lammps-data": data_head() + rows("{id} 1 {d} 2500 {x} {y} {z} 0 0 0"),
        "yade-text": "#format id_x_y_z_r\n" + rows("{id}\t{x}\t{y}\t{z}\t{r}"),
        "mercury-data": f"{COUNT} 0 {box}\n" + rows("{x} {y} {z} {vx} {vy} {vz} {r} 0 0 0 0 0 0 0"),
        "extended-xyz": xyz_head() + rows("1 {x} {y} {z} {vx} {vy} {vz} {r} {id}"),
        "legacy-vtk": legacy(),
        "vtk-xml": xml(),
    }


def write_vtkhdf(path, **options):
    """VTKHDF as another code would write it."""
    points, radii, velocity, ids = particles()
    with h5py.File(path, "w", **options) as file:
        root = file.create_group("VTKHDF")
        root.attrs["Version"] = np.array([2, 0])
        root.attrs.create("Type", b"PolyData", dtype="S8")
        root["NumberOfPoints"] = np.array([COUNT])
        root["Points"] = points
        for name, values in (("radius", radii), ("velocity", velocity), ("id", ids)):
            root[f"PointData/{name}"] = values
