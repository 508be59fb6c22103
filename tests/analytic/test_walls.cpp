#include <cmath>

#include <gtest/gtest.h>

#include "tests/support/small_scene.hpp"
#include "tests/support/verification.hpp"

namespace recoat {
namespace {

using testing::SmallScene;
using testing::verify;
using testing::verify_relative;
namespace powder = testing::powder;

constexpr double speed = 0.05, time_step = 2e-8, far_away = 1e-3;

/// A sphere that flies at `velocity` towards the point `target` of a box, along `direction`, head-on.
SmallScene towards(const ContactModel& model, Vec3 lower, Vec3 upper, Vec3 target, Vec3 direction, Vec3 wall_velocity) {
    SmallScene scene(model, time_step);
    scene.box(lower, upper, wall_velocity);
    scene.sphere(target - (powder::radius + 5e-9) * direction, speed * direction + wall_velocity);
    return scene;
}

/// Velocity relative to the wall after the impact.
Vec3 rebound(const SmallScene& scene) {
    const auto engine = scene.engine();
    engine->advance(1000);
    EXPECT_GT(engine->largest_overlap(), 1e-4);
    return engine->particles().velocity[0] - engine->walls().at(0).velocity;
}

Vec3 unit(Vec3 v) { return (1 / norm(v)) * v; }

// docs/physics.md section 1.3: faces, edges and corners of a box are met at the closest point, by the same law.
TEST(Walls, face_edge_and_corner_of_a_box_give_the_same_restitution) {
    const Vec3 lower = {0, 0, 0}, upper = {far_away, far_away, far_away};
    struct Case {
        Vec3 target, direction;
    };
    const Case cases[] = {
        {{0.5 * far_away, 0.5 * far_away, far_away}, {0, 0, -1}},     // face
        {{0, 0.5 * far_away, 0}, unit({1, 0, 1})},                    // edge
        {{far_away, 0.5 * far_away, far_away}, unit({-0.3, 0, -1})},  // edge, not along the diagonal
        {{0, 0, 0}, unit({1, 1, 1})},                                 // corner
        {{far_away, 0, far_away}, unit({-0.5, 0.2, -1})},             // corner, not along the diagonal
    };
    for (const Case& c : cases) {
        const Vec3 after = rebound(towards(powder::model(), lower, upper, c.target, c.direction, {}));
        verify("velocity after the impact, over that before", norm(after + 0.4 * speed * c.direction) / speed, 1e-3);
    }
}

// The wall's velocity enters the closing speed and the sliding velocity: only the relative motion counts.
TEST(Walls, that_move_give_what_walls_at_rest_give) {
    const Vec3 lower = {0, -far_away, 0}, upper = {4 * powder::diameter, far_away, far_away};
    const Vec3 frame = {0.05, 0, 0};
    for (const double bond : {0.0, 50.0}) {
        const ContactModel model = powder::model(0.001, bond);
        const Vec3 target = {0, 0, 0.5 * far_away}, aim = unit({1, 0, 0.4});
        SmallScene still = towards(model, lower, upper, target, {1, 0, 0}, {});
        SmallScene moving = towards(model, lower, upper, target, {1, 0, 0}, frame);
        still.particles.velocity[0] = speed * aim;
        moving.particles.velocity[0] = speed * aim + frame;
        const Vec3 a = rebound(still), b = rebound(moving);
        verify("velocity after the impact, over that before", norm(a - b) / speed, 2e-11);
        EXPECT_LT(a.x, 0);
    }
}

// A blade that runs into a sphere at rest throws it ahead at (1 + e) v_b, and its work is the energy gained and lost.
TEST(Walls, that_run_into_a_sphere_throw_it_ahead) {
    SmallScene scene(powder::model(), time_step);
    scene.box({-4 * powder::diameter, -far_away, 0}, {0, far_away, far_away}, {speed, 0, 0});
    scene.sphere({powder::radius + 5e-9, 0, 0.5 * far_away});
    const auto engine = scene.engine();
    engine->advance(1000);
    verify_relative("speed over 1.4 v_b", engine->particles().velocity[0].x / speed, 1.4, 1e-3);
    const EnergyLedger ledger = engine->ledger();
    // Impulse (1 + e) m v_b at the speed v_b.
    verify_relative("work of the wall", ledger.wall_work, 1.4 * powder::mass * speed * speed, 1e-3);
    verify("energy gained and lost over the work", (ledger.stored() + ledger.dissipated()) / ledger.wall_work - 1,
           1e-3);
}

// A wall that stops, is set going again and is taken away acts at the place where it is.
TEST(Walls, can_be_driven_and_taken_away) {
    SmallScene scene(powder::model(), time_step);
    scene.plane({0, 0, 0}, {0, 0, 1}, {0, 0, -1});
    scene.sphere({0, 0, powder::radius + 1e-5});
    const auto engine = scene.engine();
    engine->advance(1000);
    verify("place of the wall [m]", engine->walls().at(0).point.z + 1000 * time_step, 1e-19);
    engine->set_wall_velocity(0, {0, 0, speed});
    engine->advance(30000);
    EXPECT_NEAR(engine->walls().at(0).point.z, -1000 * time_step + 30000 * time_step * speed, 1e-15);
    EXPECT_EQ(engine->particles().velocity[0], (Vec3{}));
    engine->advance(1000);
    verify_relative("speed over 1.4 v", engine->particles().velocity[0].z / speed, 1.4, 1e-3);
    engine->remove_wall(0);
    EXPECT_TRUE(engine->contacts().empty());
    EXPECT_FALSE(engine->walls().at(0).active);
}

}  // namespace
}  // namespace recoat
