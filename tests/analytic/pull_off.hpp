#pragma once

#include <cmath>
#include <cstdint>

#include "tests/support/small_scene.hpp"

namespace recoat::testing {

/// Gravity, as a multiple of `unit`, at which `separation` first exceeds twenty times the minimum separation, when it
/// grows evenly to 2 in 4 ms [docs/physics.md section 2.6]. Gravity changes every `part` steps: the state goes on.
template <class Separation>
double pull_off(SmallScene scene, double unit, const Separation& separation) {
    constexpr double duration = 4e-3, resolution = 4e-4;
    const auto part = std::lround(resolution * duration / 2 / scene.setup.time_step);
    auto engine = scene.engine();
    for (;;) {
        // The middle of the part.
        const double load = 2 * (engine->time() + 0.5 * static_cast<double>(part) * scene.setup.time_step) / duration;
        if (load > 2) return load;
        scene.setup.gravity = {0, 0, -load * unit};
        engine = restore_engine(scene.setup, engine->save());
        engine->advance(part);
        if (separation(engine->particles()) > 20 * scene.setup.model.minimum_separation) return load;
    }
}

inline double resting_overlap(const ContactModel& model, double hold, double reduced_radius) {
    const double force = hold * attraction_scaling(model.stiffness_ratio);
    return std::cbrt(std::pow(force / powder::hertz(model.stiffness_ratio, reduced_radius), 2));
}

/// Of a sphere under a ceiling at z = 0, which holds it with 2 Bo weights.
inline double wall_pull_off(const ContactModel& model, double time_step, double bond) {
    SmallScene scene(model, time_step);
    scene.plane({0, 0, 0}, {0, 0, -1});
    const double hold = 2 * bond * powder::weight;
    scene.sphere({0, 0, -powder::radius + resting_overlap(model, hold, powder::radius)});
    return pull_off(scene, 2 * bond * powder::gravity,
                    [](const ParticleTable& p) { return -p.position[0].z - p.radius[0]; });
}

/// Of a sphere that hangs from one of radius `upper` in a slot between two boxes, clear of the boxes.
inline double hanging_pull_off(const ContactModel& model, double time_step, double bond, double upper) {
    SmallScene scene(model, time_step, 2 * upper);
    const double r = powder::radius, half_width = 0.8 * upper, thickness = 0.2 * r;
    scene.box({half_width, -1, -thickness}, {1, 1, 0});
    scene.box({-1, -1, -thickness}, {-half_width, 1, 0});
    const double height = 0.6 * upper;  // sqrt(1 - 0.8^2): the sphere touches both edges
    scene.sphere({0, 0, height}, {}, {}, upper);
    const double reduced = upper * r / (upper + r), hold = 2 * reduced / r * bond;
    scene.sphere({0, 0, height - upper - r + resting_overlap(model, hold * powder::weight, reduced)}, {}, {}, r);
    return pull_off(scene, hold * powder::gravity, pair_separation);
}

/// Of two equal spheres.
inline double pair_pull_off(const ContactModel& model, double time_step, double bond) {
    return hanging_pull_off(model, time_step, bond, powder::radius);
}

/// From a sphere of ten times the radius, which a thousandth of the force does not move.
inline double large_pull_off(const ContactModel& model, double time_step, double bond) {
    return hanging_pull_off(model, time_step, bond, 10 * powder::radius);
}

}  // namespace recoat::testing
