#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

#include <gtest/gtest.h>

#include "tests/support/small_scene.hpp"

namespace recoat::testing {

/// A sphere at rest normal to the plane z = 0 that presses on it by its attraction `hold`, of the
/// original stiffness, and gravity; with speed and spin along the plane.
inline SmallScene resting_sphere(const ContactModel& model, double hold, double gravity, double speed,
                                 double surface_speed, double time_step = 2e-8) {
    const double force = hold * attraction_scaling(model.stiffness_ratio) + powder::mass * gravity;
    const double overlap =
        force > 0 ? std::cbrt(std::pow(force / powder::hertz(model.stiffness_ratio, powder::radius), 2)) : 0;
    SmallScene scene = over_plane(model, time_step, -overlap, {speed, 0, 0}, {0, surface_speed / powder::radius, 0});
    scene.setup.gravity = {0, 0, -gravity};
    return scene;
}

/// The attraction of a wall at the Bond number `bond` of a pair [N].
inline double wall_hold(double bond) { return 2 * bond * powder::weight; }

/// Step for ways to rest of seconds' worth of steps: that of the paper, or five times as long on a device [s].
inline double step_of_long_ways() { return on_device() ? 1e-7 : 2e-8; }

/// How a sphere came to rest; ways in diameters, times in seconds.
struct Stop {
    double roll_start = 0, slip_time = 0;  ///< until it rolls without sliding
    double distance = 0, time = 0;         ///< until it rests
};

/// Runs until the sphere rests. Between samples the speed is taken as the straight line that constant braking gives.
inline Stop run_to_rest(const SmallScene& scene, double expected_slip_time, double expected_time) {
    const auto engine = scene.engine();
    const double start = scene.particles.position[0].x, dt = scene.setup.time_step;
    const auto at_least_one = [&](double time) { return std::max<std::int64_t>(1, std::lround(time / dt)); };
    Stop stop;
    // While it slides, the speed of the surface over the wall falls evenly: zero lies where two samples point to.
    const auto sample = [&] {
        const ParticleTable p = engine->particles();
        return p.velocity[0].x - p.angular_velocity[0].y * powder::radius;
    };
    if (sample() > 0) {
        engine->advance(at_least_one(0.3 * expected_slip_time));
        const double first = sample(), first_time = engine->time();
        engine->advance(at_least_one(0.5 * expected_slip_time));
        const double second = sample(), second_time = engine->time();
        const ParticleTable now = engine->particles();
        const double left = second * (second_time - first_time) / (first - second);
        stop.slip_time = second_time + left;
        // Sliding friction brakes by 1/(3.5 - 2.5 mu_r/mu) of the rate of the surface's speed.
        const ContactModel& m = scene.setup.model;
        const double slower = second / (3.5 - 2.5 * m.rolling_friction / m.sliding_friction);
        stop.roll_start = (now.position[0].x - start + (now.velocity[0].x - 0.5 * slower) * left) / powder::diameter;
    }
    const auto part = at_least_one(expected_time / 500);
    while (engine->time() < 3 * expected_time) {
        engine->advance(part);
        const ParticleTable now = engine->particles();
        if (std::fabs(now.velocity[0].x) > 1e-4) continue;
        const double before = now.velocity[0].x, time = engine->time();
        engine->advance(part);
        const double brake = (before - engine->particles().velocity[0].x) / (engine->time() - time);
        const double left = brake > 0 ? before / brake : 0;
        stop.distance = (now.position[0].x - start + 0.5 * before * left) / powder::diameter;
        stop.time = time + left;
        return stop;
    }
    ADD_FAILURE() << "the sphere did not stop";
    return stop;
}

}  // namespace recoat::testing
