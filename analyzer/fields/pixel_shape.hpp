#pragma once

#include <optional>
#include <span>

#include "analyzer/fields/grid.hpp"
#include "analyzer/fields/grid_pores.hpp"

namespace recoat {

/// Shape of a set of cells of a grid. Lengths in the unit of the sides of the cells.
struct PixelShape {
    std::optional<double> angle;  ///< of the long principal axis to x, in [0, 90] [deg]; none where no axis stands out
    double elongation = 1;        ///< square root of the ratio of the principal second moments, >= 1
    double hull_area = 0, hull_perimeter = 0;  ///< convex hull of the corners of the cells
    double rect_long = 0, rect_short = 0;      ///< sides of the rectangle of the smallest area round the cells
    double extent_x = 0, extent_y = 0;         ///< sides of the box along x and y round the cells
};

/// Measures cells at the given places; at least one. The second moments are those of the cells' area, 1/12 of each
/// cell's own included, so that a rectangle of the sides a and b has the elongation a/b.
[[nodiscard]] PixelShape pixel_shape(std::span<const GridCell> cells, Sides cell);

}  // namespace recoat
