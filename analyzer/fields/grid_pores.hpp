#pragma once

#include <vector>

#include "analyzer/fields/map.hpp"

namespace recoat {

/// Neighbours of a cell on the grid: those across its sides, or those across its corners as well.
enum class GridConnectivity { sides = 4, sides_and_corners = 8 };

/// A cell by its place in a map. iy is unwrapped: it may lie outside the period, so that a pore is in one piece.
struct GridCell {
    int ix = 0, iy = 0;
};

/// One connected set of cells of a map.
struct GridPore {
    std::vector<GridCell> cells;  ///< in the order in which a breadth-first walk from the first of them finds them
    bool percolates = false;      ///< winds round the y period: two ways to a cell differ by a period
};

/// Connected sets of the cells whose value is less than `threshold`, periodic along y, in the order of their first
/// cells.
[[nodiscard]] std::vector<GridPore> grid_pores(const Map& map, double threshold, GridConnectivity connectivity);

}  // namespace recoat
