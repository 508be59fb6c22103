"""Made-up powder for tests of the workflow: states in the VTKHDF layout and summaries that are cheap to make."""

import json

import h5py
import numpy

DIAMETER = 5e-5
SCENE = """
scene: spread
blade: {thickness: 4 dp, clearance: 1.5 dp, speed: 50 mm/s}
box: {width: %g dp, fill_length: %g dp}
"""


def packed_bed(seed, length, width, count):
    """Centres [d_p] of a loose square packing between blade (x = 4) and gate."""
    generator = numpy.random.default_rng(seed)
    per_layer = int(length) * int(width)
    number = numpy.arange(count)
    layer, place = number // per_layer, number % per_layer
    centres = numpy.column_stack([4.5 + place // int(width), 0.5 + place % int(width), 0.5 + 1.01 * layer])
    return centres + generator.uniform(-0.002, 0.0, centres.shape) * [1, 1, 0]


def spread_layer(seed, bond, length, width, count):
    """Centres [d_p] of chains on the base, turned across x as cohesion grows, and of the heap before the blade."""
    generator = numpy.random.default_rng([seed, int(10 * bond)])
    wanted = min(int((0.6 - 0.0005 * bond) * length * width), count)
    centres = []
    for _ in range(60 * wanted):
        if len(centres) >= wanted:
            break
        place = numpy.array([generator.uniform(0.5, length), generator.uniform(0, width), 0.5])
        group = [place]
        while generator.random() < 0.45:
            angle = generator.uniform(-0.9, 0.9) + (numpy.pi / 2 if bond > 5 else 0)
            rise = 0.4 if bond > 5 and generator.random() < 0.1 else 0.0
            run = numpy.sqrt(1.001**2 - rise**2)
            group.append(group[-1] + [run * numpy.cos(angle), run * numpy.sin(angle), rise])
        if all(place[2] < 1.0 and is_free(place, centres, width) for place in group):
            centres += group
    centres = numpy.array(centres)[:count]
    rest = numpy.arange(count - len(centres))
    heap = numpy.column_stack(
        [length + 4.6 + rest // int(width) % 6, 0.5 + rest % int(width), 0.5 + 1.1 * (rest // (6 * int(width)))]
    )
    centres = numpy.vstack([centres, heap])
    centres[:, 1] %= width
    return centres


def is_free(place, centres, width):
    """No other centre nearer than 1.02 d_p, over the periodic boundary."""
    if not centres:
        return True
    apart = numpy.array(centres) - place
    apart[:, 1] -= width * numpy.round(apart[:, 1] / width)
    return (apart**2).sum(axis=1).min() > 1.02**2


def write_state(path, centres, stage, bond, ratio, seed, length, width, fill_length):
    """A state file as recoat-solve writes it; centres in d_p."""
    count = len(centres)
    with h5py.File(path, "w") as file:
        root = file.create_group("VTKHDF")
        root.attrs["Version"] = numpy.array([2, 0])
        root.attrs.create("Type", numpy.bytes_("PolyData"))
        root["NumberOfPoints"] = numpy.array([count])
        root["Points"] = centres * DIAMETER
        data = {
            "Id": numpy.arange(count),
            "Radius": numpy.full(count, 0.5 * DIAMETER),
            "Velocity": numpy.zeros((count, 3)),
            "AngularVelocity": numpy.zeros((count, 3)),
        }
        for name, values in data.items():
            root[f"PointData/{name}"] = values
            root[f"Steps/PointDataOffsets/{name}"] = numpy.array([0])
        root["Steps/PointOffsets"] = numpy.array([0])
        root["Steps"].attrs["NSteps"] = 1
        attributes = file.create_group("recoat").attrs
        attributes.update(
            {
                "program_version": "0.0-double",
                "config": SCENE % (width, fill_length),
                "stage": stage,
                "seed": seed,
                "diameter": DIAMETER,
                "density": 4430.0,
                "y_min": 0.0,
                "y_period": width * DIAMETER,
                "clearance": 1.5 * DIAMETER,
                "blade_start": 0.0,
                "spread_length": length * DIAMETER if stage == "spread" else numpy.nan,
                "layer_end": length * DIAMETER if stage == "spread" else numpy.nan,
                "bond_number": bond,
                "stiffness_ratio": ratio,
            }
        )


def summary(stages, bond=5.0, ratio=0.001, seed=1, particles=300):
    """A summary of a run in which nothing is wrong."""
    steps = 100_000
    stage = {
        "steps": steps,
        "time": 2e-3,
        "settled": True,
        "wall_seconds": 3.0,
        "kinetic_energy": 1e-18,
        "particle_steps_per_second": particles * steps / 3.0,
        "largest_overlap": 0.002,
    }
    return {
        "version": "0.0-double",
        "config": "",
        "seed": seed,
        "particles": particles,
        "bond_number": bond,
        "stiffness_ratio": ratio,
        "time_step": 2e-8,
        "status": "finished",
        "stages": [{"name": name, **stage} for name in stages],
        "energy": {
            "kinetic_translation": 0.0,
            "gravity": 1e-10,
            "dissipated_normal": 6e-10,
            "dissipated_tangential": 3e-10,
            "dissipated_rolling": 1e-10,
            "wall_work": 1e-9 if "spread" in stages else 0.0,
            "balance_error": 2e-12,
            "balance_error_relative": 0.002,
        },
        "particles_lost": 0,
        "wall_seconds": 3.0 * len(stages),
        "threads": 1,
    }


def write_summary(path, values):
    """As JSON."""
    path.write_text(json.dumps(values))


def write_energy(path, values):
    """energy.csv of a run that loses its energy evenly over its steps."""
    steps = sum(stage["steps"] for stage in values["stages"])
    names = ("dissipated_normal", "dissipated_tangential", "dissipated_rolling")
    rows = [",".join(["step", "time_s", *(f"{name}_J" for name in names)])]
    for part in (0.0, 0.5, 1.0):
        rows.append(",".join(f"{part * value:.9g}" for value in (steps, 1e-8 * steps, *(values["energy"][name] for name in names))))
    path.write_text("\n".join(rows) + "\n")
