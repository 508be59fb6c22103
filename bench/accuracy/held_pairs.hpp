#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "solver/engine/engine.hpp"
#include "solver/engine/particles.hpp"
#include "solver/engine/partner.hpp"

namespace recoat {

/// Pairs whose attraction a processor takes for the constant of the overlap because they cannot leave it within the
/// step [docs/physics.md section 2.5], and those of them that have left it all the same.
struct HeldPairs {
    std::int64_t held = 0, left = 0;
    double missed = 0;    ///< work of the attraction that those were not charged for [J]
    double furthest = 0;  ///< separation of the one that went furthest [m]

    void add(const HeldPairs& other) {
        held += other.held;
        left += other.left;
        missed += other.missed;
        furthest = std::max(furthest, other.furthest);
    }
};

/// Those of the step that `engine` has just made, from what a checkpoint holds. Spheres of one size only.
inline HeldPairs held_pairs(const Engine& engine, const EngineSetup& setup) {
    const EngineState state = engine.save();
    const std::vector<double>& rows = state.reals.at("particles/position");
    const std::vector<double>& attraction = state.reals.at("contacts/attraction");
    const std::vector<std::int64_t>& first = state.integers.at("contacts/first");
    const std::vector<std::int64_t>& second = state.integers.at("contacts/second");
    const auto centre = [&](std::int64_t i) {
        const double* row = rows.data() + 4 * i;
        return Vec3{row[0], row[1], row[2]};
    };
    const double radius = rows.at(3), range = setup.model.minimum_separation;
    const EqualSizes sizes = equal_sizes(setup.model, radius);
    const Period period(setup.y_period);
    HeldPairs found;
    for (std::size_t k = 0; k < first.size(); ++k) {
        const Coefficients& c = second[k] < 0 ? sizes.wall : sizes.pair;
        const double held = setup.precision == Precision::mixed
                                ? static_cast<double>(static_cast<float>(c.attraction_contact))
                                : c.attraction_contact;
        // The solve of one that leaves never gives this force: some of its path has a larger one.
        if (attraction[k] != held) continue;
        ++found.held;
        double separation = 0;
        if (second[k] >= 0) {
            separation = norm(period.nearest(centre(second[k]) - centre(first[k]))) - 2 * radius;
        } else {
            const Wall& wall = engine.walls()[static_cast<std::size_t>(-1 - second[k])];
            separation = wall.kind == WallKind::plane ? PlaneShape(wall).meet(centre(first[k]), radius).separation
                                                      : BoxShape(wall).meet(centre(first[k]), radius).separation;
        }
        if (!(separation > 0)) continue;
        ++found.left;
        found.missed += (c.attraction_gap - c.attraction_contact) * std::min(separation, range);
        found.furthest = std::max(found.furthest, separation);
    }
    return found;
}

}  // namespace recoat
