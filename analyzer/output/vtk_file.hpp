#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "common/vec3.hpp"

namespace recoat {

/// A VTK XML file in the making: elements, and in them the arrays as base64 of what is in memory behind its length. Not
/// every program reads arrays that are appended as they are; OVITO does not.
class VtkFile {
public:
    /// `type` is PolyData or ImageData; `attributes` those of its element, e.g. Origin.
    explicit VtkFile(std::string type, const std::string& attributes = "");

    void text(std::string_view text) { text_ += text; }
    /// Adds an array of doubles (NaN allowed), of whole numbers, or of vectors.
    void array(const std::string& name, const std::vector<double>& values);
    void array(const std::string& name, const std::vector<std::int64_t>& values);
    void array(const std::string& name, const std::vector<Vec3>& values);

    /// Writes the file whole or not at all. Throws InputError.
    void write(const std::filesystem::path& place) const;

private:
    void add(const std::string& name, const char* type, int components, const void* data, std::uint64_t bytes);

    std::string type_, text_;
};

/// Vertices or polygons of a PolyData file, up to the data of points and cells that the caller adds between
/// <PointData> ... and </Piece>.
struct PolyCells {
    std::vector<Vec3> points;           ///< [m]
    std::vector<std::int64_t> corners;  ///< points of the cells, one after another
    std::vector<std::int64_t> ends;     ///< one past the last corner of each cell
};

/// Begins a piece: points and cells, as vertices or as polygons. The caller adds <PointData> and <CellData> and closes
/// the piece.
void begin_piece(VtkFile& file, const PolyCells& cells, bool polygons);

}  // namespace recoat
