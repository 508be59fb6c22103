#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace recoat {

/// Values at the nodes of a grid, index [ix][iy], iy running fastest.
struct Map {
    int first_x = 0;  ///< ix of the first row: not 0 where outer nodes are dropped
    int nx = 0, ny = 0;
    std::vector<double> values;

    Map() = default;
    Map(int first, int rows, int columns)
        : first_x(first), nx(rows), ny(columns), values(static_cast<std::size_t>(rows) * columns) {}

    [[nodiscard]] double& at(int ix, int iy) { return values[static_cast<std::size_t>(ix) * ny + iy]; }
    [[nodiscard]] double at(int ix, int iy) const { return values[static_cast<std::size_t>(ix) * ny + iy]; }
    [[nodiscard]] std::span<double> row(int ix) {
        return std::span(values).subspan(static_cast<std::size_t>(ix) * ny, ny);
    }
};

}  // namespace recoat
