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
using testing::Stop;
using testing::verify;
using testing::verify_relative;
using testing::wall_hold;
namespace powder = testing::powder;

constexpr double speed = 0.05;

/// From `speed` without spin, against the numbers `name` of the reference. The load counts: `factor` times gravity
/// makes ways and times without attraction shorter by that factor.
void verify_stop(const ContactModel& model, double bond, const std::string& name, double tolerance, double factor = 1,
                 double time_step = 2e-8) {
    const auto expected = [&](const char* what) { return reference(name + "." + what) / factor; };
    const auto scene = resting_sphere(model, wall_hold(bond), factor * powder::gravity, speed, 0, time_step);
    const Stop found = run_to_rest(scene, expected("slip_time"), expected("time"));
    // The overlap shortens the lever of friction: 2e-4 of the radius at Bo 400.
    verify_relative("way until it rolls", found.roll_start, expected("roll_start"), tolerance, name);
    verify_relative("time until it rolls", found.slip_time, expected("slip_time"), tolerance, name);
    verify_relative("way until it rests", found.distance, expected("distance"), tolerance, name);
    verify_relative("time until it rests", found.time, expected("time"), tolerance, name);
}

// docs/physics.md section 5.4: sliding, then rolling to rest.
TEST(Sliding, then_rolling_to_rest_under_weight_alone) {
    verify_stop(powder::model(), 0, "stop.0", 1e-3, 20, testing::step_of_long_ways());
}

class SlidingStop : public ::testing::TestWithParam<int> {
protected:
    static double time_step() { return GetParam() <= 5 ? testing::step_of_long_ways() : 2e-8; }
};

TEST_P(SlidingStop, under_attraction) {
    const std::string bond = std::to_string(GetParam());
    verify_stop(powder::model(0.001, GetParam()), GetParam(), "stop." + bond, 1e-3, 1, time_step());
}

// Section 5.4, second column: half the Hamaker constant makes the wall hold with Bo weights, as a particle does.
TEST_P(SlidingStop, on_a_wall_that_holds_as_a_particle_does) {
    const std::string bond = std::to_string(GetParam());
    verify_stop(powder::model(0.001, 0.5 * GetParam()), 0.5 * GetParam(), "stop_half." + bond, 1e-3, 1, time_step());
}

INSTANTIATE_TEST_SUITE_P(BondNumber, SlidingStop, ::testing::Values(1, 5, 50, 200, 400),
                         [](const auto& bond) { return "bond_" + std::to_string(bond.param); });

// Section 2.2: the modified normal force keeps the way at any ratio.
TEST(Sliding, does_not_depend_on_the_stiffness) {
    for (const int bond : {5, 50, 400})
        for (const double ratio : {0.1, 0.01}) {
            if (bond == 5 && testing::on_device()) continue;
            const std::string name = "stop." + std::to_string(bond);
            const auto scene = resting_sphere(powder::model(ratio, bond), wall_hold(bond), powder::gravity, speed, 0);
            const Stop found = run_to_rest(scene, reference(name + ".slip_time"), reference(name + ".time"));
            verify_relative("way at r = " + std::string(ratio == 0.1 ? "0.1" : "0.01"), found.distance,
                            reference(name + ".distance"), 1e-3, name);
        }
}

// Section 2.2: a load that lifts with 19, 99 or 199 weights a sphere held by 800; the scaled contact holds 50. Beyond
// these it is open part of the time, and yet friction is that of the original one.
TEST(Sliding, under_a_lifting_load_is_that_of_the_original_contact) {
    for (const int pull : {19, 99, 199}) {
        const std::string name = "stop_lifted." + std::to_string(pull);
        const auto scene = resting_sphere(powder::model(0.001, 400), wall_hold(400), -pull * powder::gravity, speed, 0);
        const Stop found = run_to_rest(scene, reference(name + ".slip_time"), reference(name + ".time"));
        verify_relative("way, lifted by " + std::to_string(pull) + " weights", found.distance,
                        reference(name + ".distance"), 1e-3);
    }
}

// Without rolling friction 5/7 of the speed is left, for good.
TEST(Sliding, without_rolling_friction_ends_at_five_sevenths) {
    ContactModel model = powder::model(0.001, 50);
    model.rolling_friction = 0;
    const auto scene = resting_sphere(model, wall_hold(50), powder::gravity, speed, 0);
    const double slip_time = 2 * speed / (7 * model.sliding_friction * 101 * powder::gravity);
    const auto engine = scene.engine();
    for (const double time : {2 * slip_time, 6 * slip_time}) {
        engine->advance(static_cast<std::int64_t>(time / 2e-8) - engine->step());
        const ParticleTable now = engine->particles();
        verify_relative("speed", now.velocity[0].x / speed, 5.0 / 7, 2e-4);
        verify_relative("spin", now.angular_velocity[0].y * powder::radius / speed, 5.0 / 7, 1e-3);
    }
    // Sliding ends when the closed form says: half-way the speed is still half-way.
    const auto half = scene.engine();
    half->advance(static_cast<std::int64_t>(std::lround(0.5 * slip_time / 2e-8)));
    verify_relative("speed half-way through sliding", half->particles().velocity[0].x / speed, 6.0 / 7, 1e-3);
}

}  // namespace
}  // namespace recoat
