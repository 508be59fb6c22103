"""Reading states and choosing the analysed regions."""

import h5py
import numpy
import pytest
import synthetic
from bed_region import bed_region
from layer_region import layer_region
from reporting import Implausible
from states import fill_box, length, read_state

DIAMETER = synthetic.DIAMETER


@pytest.fixture
def state(tmp_path):
    path = tmp_path / "spread.vtkhdf"
    centres = numpy.array([[4.5, 0.5, 0.5], [5.5, 0.5, 2.5]])
    synthetic.write_state(path, centres, "spread", 5.0, 0.001, 1, length=60, width=12, fill_length=10)
    return read_state(path)


def test_read_state(state):
    assert state.points / DIAMETER == pytest.approx(numpy.array([[4.5, 0.5, 0.5], [5.5, 0.5, 2.5]]))
    assert state.data["Id"].tolist() == [0, 1]
    assert state.radius == pytest.approx([0.5 * DIAMETER] * 2)
    assert state.info["program_version"] == "0.0-double"


def test_last_step_of_a_trajectory(tmp_path):
    path = tmp_path / "trajectory.vtkhdf"
    with h5py.File(path, "w") as file:
        file["VTKHDF/NumberOfPoints"] = numpy.array([2, 3])
        file["VTKHDF/Points"] = numpy.arange(15.0).reshape(5, 3)
        file["VTKHDF/PointData/Id"] = numpy.array([0, 1, 0, 1, 2])
        file["VTKHDF/PointData/Radius"] = numpy.array([1.0, 2.0, 3.0])
        file["VTKHDF/Steps/PointOffsets"] = numpy.array([0, 2])
        file["VTKHDF/Steps/PointDataOffsets/Id"] = numpy.array([0, 2])
        file["VTKHDF/Steps/PointDataOffsets/Radius"] = numpy.array([0, 0])
        file.create_group("recoat")
    state = read_state(path)
    assert state.points[0].tolist() == [6, 7, 8] and len(state.points) == 3
    assert state.data["Id"].tolist() == [0, 1, 2]
    assert state.radius.tolist() == [1, 2, 3]


@pytest.mark.parametrize(
    "text, metres", [("4 dp", 4 * DIAMETER), ("50 um", 5e-5), ("0.0002 m", 2e-4), ("1e-1 mm", 1e-4)]
)
def test_length(text, metres):
    assert length(text, DIAMETER) == pytest.approx(metres)


def test_length_without_unit_is_refused():
    with pytest.raises(Implausible, match='"4" is not a length'):
        length("4", DIAMETER)


def test_fill_box_is_between_blade_and_gate(state):
    assert fill_box(state) == pytest.approx((4 * DIAMETER, 14 * DIAMETER))


def test_layer_region_is_the_path_less_its_ends(state):
    region = layer_region(state, 20, 10, {"voxels_per_dp": [10]})
    assert region["x_range"] == pytest.approx([20 * DIAMETER, 50 * DIAMETER])
    assert region["h_b"] == pytest.approx(1.5 * DIAMETER)
    assert region["y_period"] == pytest.approx(12 * DIAMETER)


def test_layer_region_is_a_whole_number_of_cells(state):
    state.info["spread_length"] = 60.7 * DIAMETER
    start, end = layer_region(state, 20, 10, {"voxels_per_dp": [10]})["x_range"]
    assert (end - start) / DIAMETER == pytest.approx(30)


def test_layer_region_ends_before_what_flowed_back_under_the_blade(state):
    def end(layer_end):
        state.info["layer_end"] = layer_end * DIAMETER
        return layer_region(state, 20, 10, {})["x_range"][1] / DIAMETER

    assert end(60) == pytest.approx(50)
    assert end(51) == pytest.approx(50), "the region and its windows are not reached"
    assert end(50.9) == pytest.approx(49)
    assert end(43.2) == pytest.approx(42)
    with pytest.raises(Implausible, match="powder flowed back over the last 37"):
        end(23)


def test_state_without_the_end_of_the_layer_is_refused(state):
    del state.info["layer_end"]
    with pytest.raises(Implausible, match="older recoat-solve wrote it; make it again"):
        layer_region(state, 20, 10, {})


def test_paper_region(state):
    state.info["spread_length"] = state.info["layer_end"] = 500 * DIAMETER
    assert layer_region(state, 100, 10, {})["x_range"] == pytest.approx([100 * DIAMETER, 490 * DIAMETER])


def test_spread_too_short(state):
    with pytest.raises(Implausible, match="the blade spread 60 particle diameters, of which 50 at the start"):
        layer_region(state, 50, 10, {"voxels_per_dp": []})


def test_bed_region_reaches_to_nine_tenths_of_the_top(state):
    region = bed_region(state, [])
    assert region["h_b"] == pytest.approx(0.9 * 3.0 * DIAMETER)
    assert region["x_range"] == pytest.approx([4 * DIAMETER, 14 * DIAMETER])
