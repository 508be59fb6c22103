#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace recoat {

/// A point of the top view [d_p].
struct PlanePoint {
    double x = 0, y = 0;
};

/// Of points that lie within `tolerance` of each other along x and y, periodic along y, the lowest index: one entry per
/// point, its own index where no point is near. y of the points is in [0, period).
[[nodiscard]] std::vector<std::size_t> first_coincident(std::span<const PlanePoint> points, double period,
                                                        double tolerance);

}  // namespace recoat
