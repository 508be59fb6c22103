#pragma once

#include <algorithm>
#include <limits>

#include "solver/engine/row.hpp"
#include "solver/execution/reductions.hpp"

namespace recoat {

/// The box around the ways that things have gone: no two of them have come closer by more than its diagonal. What all
/// have gone together does not count, so that a heap that a blade pushes is seen from beside it.
struct SpreadOfWays {
    double lower[3] = {none, none, none}, upper[3] = {-none, -none, -none};  ///< [m]

    static constexpr double none = std::numeric_limits<double>::infinity();

    void include(Vec3 way) {
        const double along[3] = {way.x, way.y, way.z};
        for (int axis = 0; axis < 3; ++axis) {
            lower[axis] = std::min(lower[axis], along[axis]);
            upper[axis] = std::max(upper[axis], along[axis]);
        }
    }
    [[nodiscard]] bool empty() const { return !(upper[0] >= lower[0]); }
    /// Bound of how much two have come closer [m].
    [[nodiscard]] double widest() const {
        return empty() ? 0 : norm(Vec3{upper[0] - lower[0], upper[1] - lower[1], upper[2] - lower[2]});
    }
    /// Bound of how far anything has gone [m].
    [[nodiscard]] double farthest() const {
        const auto along = [this](int axis) { return std::max(-lower[axis], upper[axis]); };
        return empty() ? 0 : norm(Vec3{along(0), along(1), along(2)});
    }
};

/// Way of a particle along an axis, with a sign [m].
struct SignedWay {
    const Row *now, *before;
    int axis;
    double sign;

    RECOAT_HD double operator()(std::size_t i) const {
        const Row &p = now[i], &q = before[i];
        return sign * (axis == 0 ? p.x - q.x : axis == 1 ? p.y - q.y : p.z - q.z);
    }
};

/// Of the first `n` particles, from `before` to `now`.
template <class Space>
SpreadOfWays spread_of_ways(Space& space, const Row* now, const Row* before, std::size_t n) {
    SpreadOfWays spread;
    if (n == 0) return spread;
    if constexpr (Space::on_host) {
        for (std::size_t i = 0; i < n; ++i) spread.include(now[i].xyz() - before[i].xyz());
    } else {
        using Largest = MaximumOf<SignedWay>;
        const auto found = space.reduce(Largest{n, {now, before, 0, 1}}, Largest{n, {now, before, 1, 1}},
                                        Largest{n, {now, before, 2, 1}}, Largest{n, {now, before, 0, -1}},
                                        Largest{n, {now, before, 1, -1}}, Largest{n, {now, before, 2, -1}});
        for (std::size_t a = 0; a < 3; ++a) {
            spread.upper[a] = found[a];
            spread.lower[a] = -found[3 + a];
        }
    }
    return spread;
}

}  // namespace recoat
