#pragma once

#include <algorithm>
#include <cmath>
#include <string>

#include <gtest/gtest.h>

#include "tests/analytic/phases.hpp"
#include "tests/support/reference.hpp"

namespace recoat::testing {

/// A pair, or a sphere and a wall, that meet under attraction; seen by separation and its rate only. Speeds are those
/// at the cut-off of the attraction.
struct Approach {
    ContactModel model;
    bool wall = false;
    double time_step = 2e-8;

    /// Speed after an impact from `speed`; 0: captured. `phase`: of the first step. Beyond `horizon` the work of the
    /// attraction is taken from its closed form.
    [[nodiscard]] double rebound(double speed, double phase, double horizon) const {
        const double arrival = std::sqrt(speed * speed + 2 * work_beyond(horizon));
        const double start = horizon + phase * arrival * time_step;
        const auto scene = wall ? over_plane(model, time_step, start, {0, 0, -arrival})
                                : head_on_pair(model, time_step, start, arrival);
        const auto engine = scene.engine();
        bool turned = false;
        while (engine->time() < 3 * horizon / arrival + 1e-2) {
            engine->advance(4);
            const ParticleTable now = engine->particles();
            const double separation = wall ? now.position[0].z - now.radius[0] : pair_separation(now);
            const double rate = wall ? now.velocity[0].z : pair_rate(now);
            if (turned && rate < 0) return 0;
            turned = rate > 0;
            if (turned && separation >= horizon)
                return std::sqrt(std::max(0.0, rate * rate - 2 * work_beyond(separation)));
        }
        ADD_FAILURE() << "neither captured nor gone";
        return 0;
    }

    /// Speed below which the partners stay together, to 1e-5 of `guess`; within `width` of it.
    [[nodiscard]] double capture(double guess, double phase, double width) const {
        const double horizon = 20 * model.minimum_separation;
        double lower = (1 - width) * guess, upper = (1 + width) * guess;
        EXPECT_EQ(rebound(lower, phase, horizon), 0);
        EXPECT_GT(rebound(upper, phase, horizon), 0);
        while (upper - lower > 2e-5 * guess) {
            const double middle = 0.5 * (lower + upper);
            (rebound(middle, phase, horizon) > 0 ? upper : lower) = middle;
        }
        return 0.5 * (lower + upper);
    }

    [[nodiscard]] std::string kind() const { return wall ? "wall" : "pair"; }

private:
    /// From `separation`, in the range of 1/s^2, to the cut-off; over the reduced mass [docs/physics.md section 2.4].
    [[nodiscard]] double work_beyond(double separation) const {
        const double outside =
            model.non_contact == NonContactHamaker::original ? 1 : attraction_scaling(model.stiffness_ratio);
        // Force over reduced mass: the same for a pair, A R/12 over m/2, and for a wall, A R/6 over m.
        const double strength = outside * model.hamaker * powder::radius / 6 / powder::mass;
        return strength * std::max(0.0, 1 / separation - 1 / model.cut_off);
    }
};

/// Phases of a step that flights under attraction are made for: a quarter of `phases` on a device.
inline int flights(int phases) { return on_device() ? std::max(2, phases / 4) : phases; }

/// Relative errors of the capture velocity of the Bond number over the phases. It is looked for within `width` of
/// `guess` times the reference.
inline Errors capture_errors(const Approach& approach, int bond, int phases, double width, double guess = 1) {
    const double expected = reference("capture." + approach.kind() + "." + std::to_string(bond));
    return over_phases(flights(phases),
                       [&](double phase) { return approach.capture(guess * expected, phase, width) / expected - 1; });
}

}  // namespace recoat::testing
