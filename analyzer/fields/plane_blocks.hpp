#pragma once

#include <vector>

#include "analyzer/fields/top_view.hpp"

namespace recoat {

/// A rectangle of the top view and the disks, and copies of disks, whose centres are in it or near it.
struct PlaneBlock {
    double x_begin = 0, x_end = 0;  ///< infinite at the ends of the data
    double y_begin = 0, y_end = 0;  ///< 0 and the period where there is one block along y
    std::vector<Disk> disks;

    /// Whether a point belongs to the block; every point with y in [0, period) belongs to exactly one block.
    [[nodiscard]] bool holds(double x, double y) const {
        return x >= x_begin && x < x_end && y >= y_begin && y < y_end;
    }
};

/// Divides the top view into blocks of a few thousand disks, each with all that lies within `margin` of it. What a
/// point depends on is in its block if it is no farther than that: blocks can be worked on one by one, in a memory that
/// does not grow with the layer, and at once. Along y no more than half a period is taken beyond a block: the nearest
/// copy of a disk is never farther. The division depends on the disks alone.
[[nodiscard]] std::vector<PlaneBlock> plane_blocks(const TopView& view, double margin);

/// An upper bound on the distance from any point between the outermost centres along x to the nearest centre, copies
/// included; at least one disk.
[[nodiscard]] double farthest_from_centres(const TopView& view);

}  // namespace recoat
