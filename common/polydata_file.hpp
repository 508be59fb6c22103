#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "common/hdf5.hpp"
#include "common/vec3.hpp"

namespace recoat {

/// Cells of one kind: cell k has the points connectivity[offsets[k]] to connectivity[offsets[k + 1] - 1].
struct PolyCells {
    std::vector<std::int64_t> connectivity;
    std::vector<std::int64_t> offsets = {0};

    [[nodiscard]] std::int64_t size() const { return static_cast<std::int64_t>(offsets.size()) - 1; }
};

/// A VTKHDF file (version 2.0) of type PolyData with several time steps, that ParaView 5.12 opens as it is. For each
/// step: `add` values to every array that was made, then `finish_step`.
class PolyDataFile {
public:
    /// Chunks of arrays hold this many rows, so that one is just what a usual step needs.
    PolyDataFile(const std::filesystem::path& path, std::size_t points_per_chunk, std::size_t polygons_per_chunk);

    [[nodiscard]] const hdf5::Group& root() const { return file_; }

    /// Makes PointData/NAME or CellData/NAME (of the polygons); `unit` may be empty. Throws std::invalid_argument for
    /// a name that readers would not see.
    template <class Number>
    void make_point_array(const std::string& name, std::size_t components, const std::string& unit) {
        make_array<Number>("PointData", name, components, unit, points_per_chunk_);
    }
    template <class Number>
    void make_polygon_array(const std::string& name, std::size_t components, const std::string& unit) {
        make_array<Number>("CellData", name, components, unit, polygons_per_chunk_);
    }
    void add(const std::string& path, const std::vector<std::int64_t>& values) { arrays_.at(path).append(values); }
    void add(const std::string& path, const std::vector<double>& values) { arrays_.at(path).append(values); }
    void add(const std::string& path, const std::vector<Vec3>& values);

    /// Adds points and cells of a step at `time` [s], makes it visible to readers, and brings it to the disk.
    void finish_step(double time, std::int64_t step, const std::vector<Vec3>& points, const PolyCells& vertices,
                     const PolyCells& polygons);

private:
    template <class Number>
    void make(const std::string& path, const hdf5::Shape& row, std::size_t rows_per_chunk) {
        arrays_.emplace(path, vtk_.create_extendible<Number>(path, row, rows_per_chunk));
    }
    template <class Number>
    void make_array(const std::string& group, const std::string& name, std::size_t components, const std::string& unit,
                    std::size_t rows_per_chunk) {
        require_valid_name(name);
        const std::string path = group + "/" + name;
        make<Number>(path, components == 1 ? hdf5::Shape{} : hdf5::Shape{components}, rows_per_chunk);
        if (!unit.empty()) vtk_.set_dataset_attribute(path, "unit", unit);
        make<std::int64_t>("Steps/" + group + "Offsets/" + name, {}, steps_per_chunk);
    }

    static constexpr std::size_t steps_per_chunk = 64;
    static void require_valid_name(const std::string& name);
    void make_cells(const std::string& kind, std::size_t rows_per_chunk);
    void make_steps();
    void add_cells(const std::string& kind, const PolyCells& cells);
    void add_offsets(double time, std::int64_t step);

    hdf5::File file_;
    hdf5::Group vtk_;
    std::map<std::string, hdf5::Dataset> arrays_;  ///< by their path below /VTKHDF
    std::size_t points_per_chunk_, polygons_per_chunk_;
    // of all steps so far
    std::int64_t steps_ = 0, points_ = 0;
    std::int64_t vertices_ = 0, vertex_ids_ = 0, polygons_ = 0, polygon_ids_ = 0;
};

}  // namespace recoat
