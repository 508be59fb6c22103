#include <gtest/gtest.h>

#include "tests/solver/engine/engine_scenes.hpp"

namespace recoat {
namespace {

using namespace testing;

// Spheres that fly and turn apart from each other hold 0, 1, 4, 9, ... units.
TEST(Rest, LeavesOutThoseThatHoldMost) {
    EngineScene scene;
    scene.setup = paper_setup();
    scene.setup.gravity = {};
    constexpr int count = 8;
    constexpr double speed = 1e-3;
    for (int i = 0; i < count; ++i) {
        // In no order; the odd ones turn: 2/5 m r^2 w^2 = m v^2.
        const double fast = speed * ((5 * i) % count);
        const Vec3 place = {3.0 * i * dp, 0, 0};
        if (i % 2 == 0)
            add_particle(scene.particles, place, {0, fast, 0});
        else
            add_particle(scene.particles, place, {}, {fast / (paper_radius * std::sqrt(0.4)), 0, 0});
    }
    const auto engine = scene.engine();
    const double unit = 0.5 * sphere_mass(paper_radius, 4430) * speed * speed;
    double sum = 0;
    for (int slowest = 0; slowest < count; ++slowest) {
        sum += unit * slowest * slowest;
        const auto left_out = static_cast<std::size_t>(count - 1 - slowest);
        EXPECT_TRUE(engine->at_rest({1.001 * sum + 1e-6 * unit, left_out})) << slowest;
        EXPECT_FALSE(engine->at_rest({0.999 * sum, left_out})) << slowest;
    }
    EXPECT_TRUE(engine->at_rest({1e-6 * unit, count}));
    EXPECT_TRUE(engine->at_rest({1e-6 * unit, count + 5}));
    EXPECT_NEAR(sum / engine->kinetic_energy(), 1, 1e-9);
}

// Ahead of a front one that moves on counts for nothing, one that comes back does, and so does one behind.
TEST(Rest, LeavesOutThoseThatMoveOnAhead) {
    const auto moving = [](double x, double speed) {
        EngineScene scene;
        scene.setup = paper_setup();
        scene.setup.gravity = {};
        add_particle(scene.particles, {x * dp, 0, 0}, {speed, 0, 0});
        return scene.engine();
    };
    const RestLimit limit{1e-6 * 0.5 * sphere_mass(paper_radius, 4430) * 0.01 * 0.01, 0, 10 * dp};
    EXPECT_TRUE(moving(11, 0.01)->at_rest(limit));
    EXPECT_FALSE(moving(11, -0.01)->at_rest(limit));
    EXPECT_FALSE(moving(9, 0.01)->at_rest(limit));
}

}  // namespace
}  // namespace recoat
