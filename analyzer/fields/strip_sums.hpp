#pragma once

#include "analyzer/fields/layer.hpp"
#include "analyzer/fields/map.hpp"
#include "analyzer/fields/window_strips.hpp"

namespace recoat {

/// The strips of a window size over a layer, along x and, periodic, along y.
struct StripLattice {
    WindowStrips x, y;
    int nx, ny;  ///< number of strips along x that windows cover, and along y in a period

    /// @param window nominal side [d_p]
    StripLattice(const Grid& grid, double window)
        : x(grid.spacing, window, grid.stretch_x),
          y(grid.spacing, window, grid.stretch_y),
          nx(x.first(grid.nx - 1) + x.per_window()),
          ny(grid.ny * y.per_spacing()) {}

    /// Strip number along y brought into the period.
    [[nodiscard]] int wrap_y(int strip) const { return ((strip % ny) + ny) % ny; }
};

/// Combines the values of strip cells into one value per window: result(node) = combine over its cells, beginning with
/// 0, along y first, in ascending order.
template <class Combine>
Map over_windows(const Map& cells, const StripLattice& lattice, const Grid& grid, Combine combine) {
    const int run = lattice.x.per_window();
    Map along_y(0, cells.nx, grid.ny);
    for (int i = 0; i < cells.nx; ++i) {
        for (int iy = 0; iy < grid.ny; ++iy) {
            double value = 0;
            const int first = lattice.y.first(iy);
            for (int k = 0; k < run; ++k) value = combine(value, cells.at(i, lattice.wrap_y(first + k)));
            along_y.at(i, iy) = value;
        }
    }
    Map result(0, grid.nx, grid.ny);
    for (int ix = 0; ix < grid.nx; ++ix) {
        const int first = lattice.x.first(ix);
        for (int k = 0; k < run; ++k) {
            for (int iy = 0; iy < grid.ny; ++iy) {
                result.at(ix, iy) = combine(result.at(ix, iy), along_y.at(first + k, iy));
            }
        }
    }
    return result;
}

/// The rows first ... first + count - 1 of a map.
[[nodiscard]] inline Map rows_of(const Map& map, int first, int count) {
    Map part(map.first_x + first, count, map.ny);
    const auto begin = map.values.begin() + static_cast<std::ptrdiff_t>(first) * map.ny;
    part.values.assign(begin, begin + static_cast<std::ptrdiff_t>(count) * map.ny);
    return part;
}

}  // namespace recoat
