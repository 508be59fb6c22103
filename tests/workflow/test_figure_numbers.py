"""Numbers that the figures compute themselves."""

import json

import numpy
import pytest
from derived_table import flatten, table as derived_table
from fig10_cluster_size import CLASSES, class_label, class_of, class_shares
from fig12_surface_height import class_counts, node_shares
from layers import Layer, by_bond, relative_iqr, roughness
from metrics_table import perpendicular
from report import cell
from runtime_table import table as runtime_table
from style import bond_panels
import synthetic


def layer(tmp_path, bond=5.0, **values):
    """A layer with the metrics given, the region x = 2..6 d_p."""
    path = tmp_path / "layer.json"
    diameter = 5e-5
    config = {"d_p": diameter, "x_range": [2 * diameter, 6 * diameter], "y_min": 0.0, "y_period": 4 * diameter}
    path.write_text(json.dumps({"config": config, **values}))
    return Layer(bond, 0.001, 1, str(path), "", {"block_dp": 2, "bed_block_dp": 2, "resamples": 200})


def test_relative_iqr_and_roughness():
    assert relative_iqr(numpy.arange(1.0, 6.0)) == pytest.approx(2 / 3)
    assert roughness(numpy.array([[0.0, 1.0], [1.0, 0.0]])) == pytest.approx(0.5)


def test_every_cluster_size_has_one_class():
    sizes = numpy.arange(1, 200)
    classes = class_of(sizes)
    assert classes[0] == -1
    for size, number in zip(sizes[1:], classes[1:]):
        first, last = CLASSES[number]
        assert first <= size <= (last or size)


def test_class_shares():
    found = class_shares({"1": 0.5, "2": 0.2, "7": 0.1, "16": 0.05, "136": 0.15})
    assert found.tolist() == pytest.approx([0.2, 0, 0, 0.1, 0.05, 0, 0, 0.15])
    assert [class_label(*sizes) for sizes in (CLASSES[0], CLASSES[3], CLASSES[-1])] == ["2", "5–8", "≥ 65"]


def test_height_classes_are_closed_above(tmp_path):
    heights = [[0.0, 1.0, 1.0 + 1e-9], [0.25, 0.26, 1.4]]
    counts = class_counts(layer(tmp_path, maps={"height": heights}), 6, 0.25)
    assert counts.tolist() == [[1, 0, 0, 0, 2, 0, 0], [0, 1, 1, 0, 0, 0, 1]]
    assert node_shares(counts).sum() == pytest.approx(1)


def test_perpendicular_groups(tmp_path):
    particles = {"cluster_size": [1, 2, 2, 5, 3], "cluster_angle": [None, 10.0, 80.0, 45.0, None], "cn": []}
    found = layer(tmp_path, particles=particles)
    assert perpendicular(found, []).tolist() == [-1, 0, 1, 1, -1]
    assert perpendicular(found, [2]).tolist() == [-1, 0, 1, -1, -1]


def test_particles_outside_the_region_do_not_count(tmp_path):
    found = layer(tmp_path)
    found.__dict__["state"] = type(
        "S", (), {"points": numpy.array([[1.5, 0, 0], [2.0, 0, 0], [5.9, 0, 0], [6.0, 0, 0]]) * 5e-5}
    )
    assert found.counts([0, 0, 1, 1], 2).tolist() == [[1, 0], [0, 0], [0, 0], [0, 1]]


def test_panels_follow_the_paper():
    assert bond_panels([0, 1, 5]) == [("(a) Bo ≤ 1", [0, 1]), ("(b) Bo ≥ 1", [1, 5])]
    assert bond_panels([5, 50]) == [("", [5, 50])]
    assert bond_panels([0, 1]) == [("", [0, 1])]
    assert bond_panels([0, 50]) == [("(a) Bo ≤ 1", [0]), ("(b) Bo ≥ 1", [50])]


def test_groups_are_sorted_by_bond_number(tmp_path):
    groups = by_bond([layer(tmp_path, bond) for bond in (50.0, 0.0, 50.0)])
    assert list(groups) == [0.0, 50.0] and len(groups[50.0]) == 2


def test_derived_numbers_are_flattened_by_name():
    derived = {
        "mass": 1.0,
        "limits": [{"name": "Rayleigh", "limit": 2.0}, {"name": "contact", "limit": 3.0}],
        "range": [4, 5],
    }
    assert flatten(derived) == {
        "mass": 1.0,
        "limits.Rayleigh.limit": 2.0,
        "limits.contact.limit": 3.0,
        "range.0": 4,
        "range.1": 5,
    }


def test_derived_table_leaves_out_what_the_machine_decides():
    cases = [{"bond": 5.0, "ratio": 0.001, "seed": 1}]
    found = derived_table(cases, [{"mass": 1.0, "expected": {"seconds": 3.0}}])
    assert found.index.tolist() == ["mass"]


def test_runtime_of_a_run():
    found = runtime_table(
        [{"bond": 5.0, "ratio": 0.001, "seed": 1}], [synthetic.summary(["fill", "spread"], particles=300)]
    )
    assert found["stage"].tolist() == ["fill", "spread", "all"]
    assert found["particle_steps_per_second"].tolist() == pytest.approx([1e7, 1e7, 1e7])


@pytest.mark.parametrize(
    "value, text",
    [
        ("0.00012345678", "0.0001235"),
        ("sphere", "sphere"),
        (float("nan"), ""),
        (12345678, "12345678"),
        ("250", "250"),
        ("1e", "1e"),
    ],
)
def test_table_cells(value, text):
    assert cell(value) == text
