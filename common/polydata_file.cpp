#include "common/polydata_file.hpp"

#include <algorithm>
#include <stdexcept>

#include <fmt/format.h>

namespace recoat {
namespace {

using Integers = std::vector<std::int64_t>;

}  // namespace

PolyDataFile::PolyDataFile(const std::filesystem::path& path, std::size_t points_per_chunk,
                           std::size_t polygons_per_chunk)
    : file_(hdf5::File::create(path)),
      vtk_(file_.create_group("VTKHDF")),
      points_per_chunk_(std::max<std::size_t>(1, points_per_chunk)),
      polygons_per_chunk_(std::max<std::size_t>(1, polygons_per_chunk)) {
    vtk_.set_attribute("Version", Integers{2, 0});
    vtk_.set_attribute("Type", std::string("PolyData"));
    make<std::int64_t>("NumberOfPoints", {}, steps_per_chunk);
    make_cells("Vertices", points_per_chunk_);
    make_cells("Lines", 1);
    make_cells("Polygons", 4 * polygons_per_chunk_);
    make_cells("Strips", 1);
    make_steps();
    make<double>("Points", {3}, points_per_chunk_);
    vtk_.set_dataset_attribute("Points", "unit", "m");
}

void PolyDataFile::require_valid_name(const std::string& name) {
    if (name.empty() || name.find_first_of("./") != std::string::npos) {
        throw std::invalid_argument(fmt::format("state: \"{}\" cannot be the name of an array", name));
    }
}

void PolyDataFile::make_cells(const std::string& kind, std::size_t rows_per_chunk) {
    vtk_.create_group(kind);
    make<std::int64_t>(kind + "/NumberOfCells", {}, steps_per_chunk);
    make<std::int64_t>(kind + "/NumberOfConnectivityIds", {}, steps_per_chunk);
    make<std::int64_t>(kind + "/Connectivity", {}, rows_per_chunk);
    make<std::int64_t>(kind + "/Offsets", {}, rows_per_chunk + 1);
}

void PolyDataFile::make_steps() {
    for (const auto* group : {"Steps", "Steps/PointDataOffsets", "Steps/CellDataOffsets", "Steps/FieldDataOffsets",
                              "Steps/FieldDataSizes", "FieldData", "PointData", "CellData"}) {
        vtk_.create_group(group);
    }
    make<double>("Steps/Values", {}, steps_per_chunk);
    for (const auto* name : {"PartOffsets", "NumberOfParts", "PointOffsets"})
        make<std::int64_t>(fmt::format("Steps/{}", name), {}, steps_per_chunk);
    make<std::int64_t>("Steps/CellOffsets", {4}, steps_per_chunk);
    make<std::int64_t>("Steps/ConnectivityIdOffsets", {4}, steps_per_chunk);
    make<double>("FieldData/Time", {}, steps_per_chunk);
    make<std::int64_t>("FieldData/Step", {}, steps_per_chunk);
    vtk_.set_dataset_attribute("FieldData/Time", "unit", "s");
    for (const auto* name : {"Time", "Step"}) {
        make<std::int64_t>(fmt::format("Steps/FieldDataOffsets/{}", name), {}, steps_per_chunk);
        make<std::int64_t>(fmt::format("Steps/FieldDataSizes/{}", name), {2}, steps_per_chunk);
    }
}

void PolyDataFile::add(const std::string& path, const std::vector<Vec3>& values) {
    std::vector<double> flat;
    flat.reserve(3 * values.size());
    for (const Vec3& v : values) flat.insert(flat.end(), {v.x, v.y, v.z});
    arrays_.at(path).append(flat);
}

void PolyDataFile::add_cells(const std::string& kind, const PolyCells& cells) {
    add(kind + "/NumberOfCells", Integers{cells.size()});
    add(kind + "/NumberOfConnectivityIds", Integers{static_cast<std::int64_t>(cells.connectivity.size())});
    add(kind + "/Connectivity", cells.connectivity);
    add(kind + "/Offsets", cells.offsets);
}

void PolyDataFile::add_offsets(double time, std::int64_t step) {
    add("Steps/Values", std::vector{time});
    add("Steps/PartOffsets", Integers{steps_});
    add("Steps/NumberOfParts", Integers{1});
    add("Steps/PointOffsets", Integers{points_});
    add("Steps/CellOffsets", Integers{vertices_, 0, polygons_, 0});
    add("Steps/ConnectivityIdOffsets", Integers{vertex_ids_, 0, polygon_ids_, 0});
    add("FieldData/Time", std::vector{time});
    add("FieldData/Step", Integers{step});
    for (const std::string name : {"Time", "Step"}) {
        add("Steps/FieldDataOffsets/" + name, Integers{steps_});
        add("Steps/FieldDataSizes/" + name, Integers{1, 1});
    }
    for (auto& [path, array] : arrays_) {
        if (path.starts_with("Steps/PointDataOffsets/")) array.append(Integers{points_});
        if (path.starts_with("Steps/CellDataOffsets/")) array.append(Integers{polygons_});
    }
}

void PolyDataFile::finish_step(double time, std::int64_t step, const std::vector<Vec3>& points,
                               const PolyCells& vertices, const PolyCells& polygons) {
    add("Points", points);
    add("NumberOfPoints", Integers{static_cast<std::int64_t>(points.size())});
    add_cells("Vertices", vertices);
    add_cells("Lines", {});
    add_cells("Polygons", polygons);
    add_cells("Strips", {});
    add_offsets(time, step);
    points_ += static_cast<std::int64_t>(points.size());
    vertices_ += vertices.size();
    vertex_ids_ += static_cast<std::int64_t>(vertices.connectivity.size());
    polygons_ += polygons.size();
    polygon_ids_ += static_cast<std::int64_t>(polygons.connectivity.size());
    ++steps_;
    // Last, so that a reader never meets a step that is not whole.
    vtk_.group("Steps").set_attribute("NSteps", steps_);
    file_.flush();
}

}  // namespace recoat
