#pragma once

#include <cmath>
#include <cstdint>
#include <limits>

#include "solver/engine/row.hpp"
#include "solver/execution/reductions.hpp"

namespace recoat {

/// What a grid of cells is laid over.
struct Extent {
    double lower[3] = {0, 0, 0}, upper[3] = {0, 0, 0};  ///< of the centres [m]
    std::size_t particles = 0;
    double largest_radius = 0;  ///< [m]
};

/// A grid of cells over the particles, periodic in y when there is a period; x runs fastest.
struct Cells {
    double lower[3], inverse[3];
    std::int64_t along[3];  ///< number of cells
    bool periodic;

    [[nodiscard]] RECOAT_HD std::int64_t count() const { return along[0] * along[1] * along[2]; }

    RECOAT_HD std::int64_t coordinate(int axis, const Row& position) const {
        const double x = axis == 0 ? position.x : axis == 1 ? position.y : position.z;
        const double cell = std::floor((x - lower[axis]) * inverse[axis]);
        const double last = static_cast<double>(along[axis] - 1);
        // Compared this way, not-a-number comes to lie in the first cell.
        return cell > 0 ? static_cast<std::int64_t>(cell < last ? cell : last) : 0;
    }
    RECOAT_HD std::int64_t key(std::int64_t x, std::int64_t y, std::int64_t z) const {
        return (y * along[2] + z) * along[0] + x;
    }
    RECOAT_HD std::int64_t key(const Row& p) const { return key(coordinate(0, p), coordinate(1, p), coordinate(2, p)); }
};

/// `side` is the least cell size; cells grow where there would be many more of them than particles.
inline Cells make_cells(Extent extent, double side, double y_min, double y_period) {
    Cells cells{};
    cells.periodic = y_period > 0;
    if (cells.periodic) {
        extent.lower[1] = y_min;
        extent.upper[1] = y_min + y_period;
    }
    const double most = 8.0 * static_cast<double>(extent.particles) + 1000;
    const auto fit = [&](int a, double width) {
        const double cells_along = std::floor((extent.upper[a] - extent.lower[a]) / width);
        return cells_along > 1 ? cells_along : 1;
    };
    double width = side;
    while (fit(0, width) * fit(1, width) * fit(2, width) > most) width *= 1.25;
    for (int a = 0; a < 3; ++a) {
        const double length = extent.upper[a] - extent.lower[a];
        cells.lower[a] = extent.lower[a];
        cells.along[a] = static_cast<std::int64_t>(fit(a, width));
        cells.inverse[a] = length > 0 ? static_cast<double>(cells.along[a]) / length : 0;
    }
    return cells;
}

/// A coordinate of the centres, or as the fourth the radius, with a sign [m].
struct SignedCoordinate {
    const Row* position;
    int axis;
    double sign;

    RECOAT_HD double operator()(std::size_t i) const {
        const Row& p = position[i];
        return sign * (axis == 0 ? p.x : axis == 1 ? p.y : axis == 2 ? p.z : p.w);
    }
};

/// Bounds of the centres, and the largest radius.
template <class Space>
Extent extent_of(Space& space, const Row* position, std::size_t n) {
    using Largest = MaximumOf<SignedCoordinate>;
    Extent extent;
    extent.particles = n;
    if (n == 0) return extent;
    const auto found =
        space.reduce(Largest{n, {position, 0, 1}}, Largest{n, {position, 1, 1}}, Largest{n, {position, 2, 1}},
                     Largest{n, {position, 0, -1}}, Largest{n, {position, 1, -1}}, Largest{n, {position, 2, -1}},
                     Largest{n, {position, 3, 1}});
    for (std::size_t a = 0; a < 3; ++a) {
        extent.upper[a] = found[a];
        extent.lower[a] = -found[3 + a];
    }
    extent.largest_radius = found[6];
    return extent;
}

}  // namespace recoat
