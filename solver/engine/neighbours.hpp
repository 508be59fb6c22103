#pragma once

#include <cmath>
#include <cstdint>

#include "solver/engine/cells.hpp"
#include "solver/engine/partner.hpp"

namespace recoat {

/// Whether two particles are nearer than `range`. It is asked twice, to count and to fill: products and sums are fused
/// by name, so that no compiler can round the two answers differently.
RECOAT_HD bool nearer(const Row& p, const Row& q, Period period, double range) {
    const double dx = q.x - p.x, dz = q.z - p.z, across = q.y - p.y;
    const double dy = std::fma(-period.length, std::rint(across * period.inverse), across);
    const double reach = p.w + q.w + range;
    return std::fma(dx, dx, std::fma(dy, dy, dz * dz)) < reach * reach;
}

/// Finds the partners of one particle among the particles, which are sorted by cell.
struct NeighbourSearch {
    const Row* position;
    Cells cells;
    const std::int32_t* start;  ///< [cells + 1] first particle of each cell
    Period period;
    double range;  ///< [m]

    /// Calls found(j) for every j > i nearer than `range`.
    template <class Found>
    RECOAT_HD void operator()(std::int32_t i, Found&& found) const {
        const Row p = load(position, i);
        const std::int64_t x = cells.coordinate(0, p);
        const Line ys = line(1, p, cells.periodic), zs = line(2, p, false);
        const std::int64_t left = x > 0 ? x - 1 : 0, right = x + 1 < cells.along[0] ? x + 1 : x;
        for (std::int64_t a = 0; a < ys.count; ++a) {
            for (std::int64_t b = 0; b < zs.count; ++b) {
                const std::int64_t y = ys.at(a), z = zs.at(b);
                const std::int32_t first = start[cells.key(left, y, z)], last = start[cells.key(right, y, z) + 1];
                for (std::int32_t j = first > i ? first : i + 1; j < last; ++j)
                    if (nearer(p, load(position, j), period, range)) found(j);
            }
        }
    }

private:
    /// The cell of a particle and its neighbours along one axis, each once.
    struct Line {
        std::int64_t first, count, wrap;  ///< wrap: number of cells along a periodic axis, or 0

        RECOAT_HD std::int64_t at(std::int64_t k) const {
            const std::int64_t cell = first + k;
            if (wrap == 0) return cell;
            return cell < 0 ? cell + wrap : (cell >= wrap ? cell - wrap : cell);
        }
    };

    RECOAT_HD Line line(int axis, const Row& p, bool periodic) const {
        const std::int64_t at = cells.coordinate(axis, p), count = cells.along[axis];
        if (periodic) return count < 3 ? Line{0, count, 0} : Line{at - 1, 3, count};
        const std::int64_t first = at > 0 ? at - 1 : 0, last = at + 1 < count ? at + 1 : count - 1;
        return {first, last - first + 1, 0};
    }
};

}  // namespace recoat
