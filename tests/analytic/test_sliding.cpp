#include <cmath>
#include <string>

#include <gtest/gtest.h>

#include "tests/support/reference.hpp"
#include "tests/support/small_scene.hpp"

namespace recoat {
namespace {

using testing::over_plane;
using testing::reference;
using testing::SmallScene;
namespace powder = testing::powder;

/// A sphere at rest normal to the plane z = 0 under `gravity` and its attraction, with speed and spin along the plane.
SmallScene resting(const ContactModel& model, double bond, double gravity, double speed, double surface_speed,
                   double time_step = 2e-8) {
    const double held = 2 * bond * powder::weight * attraction_scaling(model.stiffness_ratio);
    const double force = held + powder::mass * gravity;
    const double overlap = std::cbrt(std::pow(force / powder::hertz(model.stiffness_ratio, powder::radius), 2));
    SmallScene scene = over_plane(model, time_step, -overlap, {speed, 0, 0}, {0, surface_speed / powder::radius, 0});
    scene.setup.gravity = {0, 0, -gravity};
    return scene;
}

struct Stop {
    double distance = 0, time = 0;
};

/// Runs until the sphere rests; distance in diameters.
Stop run_to_rest(SmallScene scene, double expected_time) {
    const auto engine = scene.engine();
    const double start = scene.particles.position[0].x;
    const auto part = static_cast<std::int64_t>(expected_time / scene.setup.time_step / 500);
    while (engine->time() < 3 * expected_time) {
        engine->advance(part);
        const ParticleTable now = engine->particles();
        if (std::fabs(now.velocity[0].x) < 1e-4) {
            // The rest of the way at the braking that it has now: from the last two samples of the speed.
            const double before = now.velocity[0].x;
            engine->advance(part);
            const double brake =
                (before - engine->particles().velocity[0].x) / (static_cast<double>(part) * scene.setup.time_step);
            const double left = brake > 0 ? before / brake : 0;
            return {(now.position[0].x - start + 0.5 * before * left) / powder::diameter,
                    engine->time() - static_cast<double>(part) * scene.setup.time_step + left};
        }
    }
    ADD_FAILURE() << "the sphere did not stop";
    return {};
}

void expect_stop(const ContactModel& model, int bond, double gravity_factor, double time_step = 2e-8) {
    const std::string name = "stop." + std::to_string(bond) + ".";
    // The load counts: without attraction more gravity only makes the way shorter, in proportion.
    const double expected_time = reference(name + "time") / gravity_factor;
    const double expected = reference(name + "distance") / gravity_factor;
    const Stop found =
        run_to_rest(resting(model, bond, gravity_factor * powder::gravity, 0.05, 0, time_step), expected_time);
    EXPECT_NEAR(found.distance / expected, 1, 1e-3) << "Bo " << bond;
    EXPECT_NEAR(found.time / expected_time, 1, 1e-3) << "Bo " << bond;
    ::testing::Test::RecordProperty("bond_" + std::to_string(bond), std::to_string(found.distance * gravity_factor));
}

// docs/physics.md section 5.4: sliding, then rolling to rest from 0.05 m/s.
TEST(Sliding, then_rolling_to_rest_under_weight_alone) { expect_stop(powder::model(), 0, 200); }

TEST(Sliding, then_rolling_to_rest_under_attraction) {
    for (const int bond : {5, 50, 200, 400}) expect_stop(powder::model(0.001, bond), bond, 1);
}

TEST(Sliding, then_rolling_to_rest_at_bond_number_1) { expect_stop(powder::model(0.001, 1), 1, 1, 1e-7); }

// Section 2.2: the modified normal force keeps the way at any ratio; time-step error 0.2 to 0.5 % at 0.1.
TEST(Sliding, does_not_depend_on_the_stiffness) {
    for (const double ratio : {0.1, 0.01}) {
        const SmallScene scene = resting(powder::model(ratio, 50), 50, powder::gravity, 0.05, 0);
        const Stop found = run_to_rest(scene, reference("stop.50.time"));
        EXPECT_NEAR(found.distance / reference("stop.50.distance"), 1, 0.005) << ratio;
    }
}

TEST(Rolling, without_sliding_stops_where_the_closed_form_says) {
    for (const int bond : {50, 400}) {
        const double expected = reference("stop." + std::to_string(bond) + ".pure_rolling");
        const SmallScene scene = resting(powder::model(0.001, bond), bond, powder::gravity, 0.05, 0.05);
        const Stop found = run_to_rest(scene, 2 * expected * powder::diameter / 0.05);
        EXPECT_NEAR(found.distance / expected, 1, 1e-3) << bond;
    }
}

// The three rolling lengths [docs/physics.md section 1.6]: on a wall R* = R; the way goes as the inverse of the length.
TEST(Rolling, length_sets_the_way) {
    const double expected = reference("stop.400.pure_rolling");
    for (const RollingForm form : {RollingForm::own, RollingForm::relative})
        for (const RollingLength length :
             {RollingLength::radius, RollingLength::reduced_radius, RollingLength::diameter}) {
            ContactModel model = powder::model(0.001, 400);
            model.rolling_length = length;
            model.rolling_form = form;
            const double factor = length == RollingLength::diameter ? 0.5 : 1;
            const SmallScene scene = resting(model, 400, powder::gravity, 0.05, 0.05);
            const Stop found = run_to_rest(scene, 2 * factor * expected * powder::diameter / 0.05);
            EXPECT_NEAR(found.distance / (factor * expected), 1, 1e-3) << static_cast<int>(length);
        }
}

// Without rolling friction 5/7 of the speed is left, for good; here it changes by less than one part in 10^4.
TEST(Sliding, without_rolling_friction_ends_at_five_sevenths) {
    ContactModel model = powder::model(0.001, 50);
    model.rolling_friction = 0;
    const double slip_time = 2 * 0.05 / (7 * model.sliding_friction * 101 * powder::gravity);
    const auto engine = resting(model, 50, powder::gravity, 0.05, 0).engine();
    for (const double time : {2 * slip_time, 6 * slip_time}) {
        engine->advance(static_cast<std::int64_t>(time / 2e-8) - engine->step());
        const ParticleTable now = engine->particles();
        EXPECT_NEAR(now.velocity[0].x / 0.05, 5.0 / 7, 1e-4);
        EXPECT_NEAR(now.angular_velocity[0].y * powder::radius / 0.05, 5.0 / 7, 1e-3);
    }
    // Sliding ends when the closed form says: half-way the speed is still half-way.
    const auto half = resting(model, 50, powder::gravity, 0.05, 0).engine();
    half->advance(static_cast<std::int64_t>(std::lround(0.5 * slip_time / 2e-8)));
    EXPECT_NEAR(half->particles().velocity[0].x / 0.05, 6.0 / 7, 1e-3);
}

// Section 3: implicit projection; a sphere at rest stays at rest, and one that stopped does not creep.
TEST(Rolling, at_rest_neither_jitters_nor_creeps) {
    const auto engine = resting(powder::model(0.001, 400), 400, powder::gravity, 0.001, 0.001).engine();
    engine->advance(5000);
    const Vec3 there = engine->particles().position[0];
    engine->advance(50000);
    const ParticleTable now = engine->particles();
    EXPECT_LT(std::fabs(now.position[0].x - there.x), 1e-6 * powder::diameter);
    EXPECT_LT(std::fabs(now.angular_velocity[0].y) * powder::radius, 1e-9);
}

}  // namespace
}  // namespace recoat
