#pragma once

#include <algorithm>
#include <limits>

#include "tests/support/small_scene.hpp"

namespace recoat::testing {

/// Errors over the phases of the first touch within a step.
struct Errors {
    double mean = 0;
    double least = std::numeric_limits<double>::infinity();
    double most = -std::numeric_limits<double>::infinity();

    [[nodiscard]] double worst() const { return std::max(most, -least); }
};

/// error(phase) at `phases` evenly spaced phases of [0, 1).
template <class Error>
Errors over_phases(int phases, const Error& error) {
    Errors found;
    for (int k = 0; k < phases; ++k) {
        const double e = error((k + 0.5) / phases);
        found.mean += e / phases;
        found.least = std::min(found.least, e);
        found.most = std::max(found.most, e);
    }
    return found;
}

/// Restitution of two spheres without attraction that close at `speed`.
inline double pair_restitution(const ContactModel& model, double time_step, double speed, double phase) {
    const auto scene = head_on_pair(model, time_step, (3 + phase) * speed * time_step, speed);
    return pair_rate(after_pair_impact(*scene.engine())) / speed;
}

/// Of one sphere on a wall.
inline double wall_restitution(const ContactModel& model, double time_step, double speed, double phase,
                               double diameter = powder::diameter) {
    const auto scene = over_plane(model, time_step, (3 + phase) * speed * time_step, {0, 0, -speed}, {}, diameter);
    return after_plane_impact(*scene.engine()).velocity[0].z / speed;
}

}  // namespace recoat::testing
