#pragma once

#include <cstddef>

#include "analyzer/division.hpp"

namespace recoat {

/// Lengths along x and y [d_p].
struct Sides {
    double x = 1, y = 1;

    [[nodiscard]] double area() const { return x * y; }
};

/// Cells of the analysis over the region; the nodes are their centres. Where the nominal side does not fit into the
/// region or into the period a whole number of times, the cells are stretched along that direction, and the windows,
/// which keep their number of cells, with them.
struct Grid {
    int nx = 0, ny = 0;                   ///< number of cells along x and y
    double spacing = 1;                   ///< nominal side of a cell [d_p]
    double stretch_x = 1, stretch_y = 1;  ///< true over nominal sides

    /// The grid over a region of this length and a period of this width [d_p].
    static Grid over(double length, double width, double spacing) {
        const Division x = divide(length / spacing), y = divide(width / spacing);
        return {static_cast<int>(x.count), static_cast<int>(y.count), spacing, x.stretch, y.stretch};
    }

    /// True sides of a square of this nominal side, be it a cell or a window.
    [[nodiscard]] Sides stretched(double side) const { return {side * stretch_x, side * stretch_y}; }
    [[nodiscard]] Sides cell() const { return stretched(spacing); }
    [[nodiscard]] double node_x(int index) const { return (index + 0.5) * spacing * stretch_x; }
    [[nodiscard]] double node_y(int index) const { return (index + 0.5) * spacing * stretch_y; }
    [[nodiscard]] std::size_t size() const { return static_cast<std::size_t>(nx) * ny; }
};

}  // namespace recoat
