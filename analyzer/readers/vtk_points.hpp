#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "analyzer/readers/source.hpp"

namespace recoat {

/// Points of a VTK file with the arrays of one number per point.
struct VtkPoints {
    std::vector<Vec3> position;
    std::vector<std::string> names;           ///< of the arrays, in small letters
    std::vector<std::vector<double>> arrays;  ///< [names][N]

    /// Whether an array of this name can be of use: a size, an identity, or what the user asks for.
    [[nodiscard]] static bool wanted(std::string_view name, const ColumnNames& chosen);
};

/// Particles from points: size and identity by the names of the arrays. `file` is for errors.
[[nodiscard]] Source particles_from(VtkPoints points, const ColumnNames& chosen, const std::string& file);

}  // namespace recoat
