#pragma once

#include <optional>
#include <span>

#include "analyzer/fields/grid_pores.hpp"

namespace recoat {

/// Shape of a set of squares of side 1. Lengths in sides.
struct PixelShape {
    std::optional<double> angle;  ///< of the long principal axis to x, in [0, 90] [deg]; none where no axis stands out
    double elongation = 1;        ///< square root of the ratio of the principal second moments, >= 1
    double hull_area = 0, hull_perimeter = 0;  ///< convex hull of the corners of the squares
    double rect_long = 0, rect_short = 0;      ///< sides of the rectangle of the smallest area round the squares
    double extent_x = 0, extent_y = 0;         ///< sides of the box along x and y round the squares
};

/// Measures squares at the given places; at least one. The second moments are those of the squares' area, 1/12 of each
/// square's own included, so that a rectangle of a x b squares has the elongation a/b.
[[nodiscard]] PixelShape pixel_shape(std::span<const GridCell> cells);

}  // namespace recoat
