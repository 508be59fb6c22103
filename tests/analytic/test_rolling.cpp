#include <cmath>
#include <string>

#include <gtest/gtest.h>

#include "tests/analytic/resting_sphere.hpp"
#include "tests/support/reference.hpp"
#include "tests/support/verification.hpp"

namespace recoat {
namespace {

using testing::reference;
using testing::resting_sphere;
using testing::run_to_rest;
using testing::verify;
using testing::verify_relative;
using testing::wall_hold;
namespace powder = testing::powder;

constexpr double speed = 0.05;

/// Way of pure rolling from `speed`, in diameters.
double way(const ContactModel& model, double bond, double gravity, double expected) {
    const double time_step = bond <= 5 ? testing::step_of_long_ways() : 2e-8;
    return run_to_rest(resting_sphere(model, wall_hold(bond), gravity, speed, speed, time_step), 0,
                       2 * expected * powder::diameter / speed)
        .distance;
}

// docs/physics.md section 5.4: x = 7 v^2/(10 mu_r g').
TEST(Rolling, without_sliding_stops_where_the_closed_form_says) {
    for (const int bond : {5, 50, 400}) {
        const double expected = reference("stop." + std::to_string(bond) + ".pure_rolling");
        verify_relative("way", way(powder::model(0.001, bond), bond, powder::gravity, expected), expected, 1e-3,
                        std::to_string(bond));
    }
    const double expected = reference("stop.0.pure_rolling") / 20;
    verify_relative("way", way(powder::model(), 0, 20 * powder::gravity, expected), expected, 1e-3, "Bo 0");
}

// The three rolling lengths [section 1.6]: on a wall R* = R; the way goes as the inverse of the length.
TEST(Rolling, length_sets_the_way) {
    const double expected = reference("stop.400.pure_rolling");
    for (const RollingForm form : {RollingForm::own, RollingForm::relative})
        for (const RollingLength length :
             {RollingLength::radius, RollingLength::reduced_radius, RollingLength::diameter}) {
            ContactModel model = powder::model(0.001, 400);
            model.rolling_length = length;
            model.rolling_form = form;
            const double shorter = length == RollingLength::diameter ? 0.5 * expected : expected;
            verify_relative("way", way(model, 400, powder::gravity, shorter), shorter, 1e-3,
                            std::to_string(static_cast<int>(length)));
        }
}

// Section 3: implicit projection; a sphere at rest stays at rest, and one that stopped does not creep.
TEST(Rolling, at_rest_neither_jitters_nor_creeps) {
    const auto engine =
        resting_sphere(powder::model(0.001, 400), wall_hold(400), powder::gravity, 0.001, 0.001).engine();
    engine->advance(5000);
    const Vec3 there = engine->particles().position[0];
    engine->advance(50000);
    const ParticleTable now = engine->particles();
    verify("creep in 1 ms [diameters]", (now.position[0].x - there.x) / powder::diameter, 1e-9);
    verify("speed of the surface [m/s]", now.angular_velocity[0].y * powder::radius, 1e-12);
}

}  // namespace
}  // namespace recoat
