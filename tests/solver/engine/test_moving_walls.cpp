#include <gtest/gtest.h>

#include "solver/engine/moving_walls.hpp"
#include "tests/solver/engine/engine_scenes.hpp"

namespace recoat {
namespace {

using namespace testing;

EngineScene with_walls(std::vector<Wall> walls) { return {paper_setup(), {}, std::move(walls)}; }

// 25 million small steps would add up to many times the rounding of one product.
TEST(MovingWalls, PositionIsOneProduct) {
    const Vec3 velocity = {0.05, -0.01, 1.0 / 3};
    MovingWalls walls({box("blade", {0.1, -infinite, 0}, {0.2, infinite, 1}, velocity), plane("gate", {}, {1, 0, 0})});
    const double step = 2e-8;
    for (std::int64_t n = 1; n <= 25'000'000; n += 999'983) walls.move(n, step);
    walls.move(25'000'000, step);
    EXPECT_DOUBLE_EQ(walls.now()[0].lower.x, 0.1 + 0.025);
    EXPECT_DOUBLE_EQ(walls.now()[0].upper.z, 1 + 0.5 / 3);
    EXPECT_EQ(walls.now()[0].lower.y, -infinite);
    EXPECT_EQ(walls.now()[1].point, (Vec3{}));
}

TEST(MovingWalls, ChangesOfVelocityStartFromWhereTheWallIs) {
    const auto engine = with_walls({plane("piston", {0, 0, 1e-3}, {0, 0, -1})}).engine();
    engine->advance(10);
    EXPECT_EQ(engine->walls()[0].point.z, 1e-3);
    engine->set_wall_velocity(0, {0, 0, 0.1});
    engine->advance(1000);
    EXPECT_DOUBLE_EQ(engine->walls()[0].point.z, 1e-3 + 1e-5);
    engine->set_wall_velocity(0, {0, 0, -0.3});
    engine->advance(500);
    EXPECT_DOUBLE_EQ(engine->walls()[0].point.z, 1e-3 + 1e-5 - 1.5e-5);
    engine->set_wall_velocity(0, {});
    engine->advance(500);
    EXPECT_DOUBLE_EQ(engine->walls()[0].point.z, 1e-3 - 5e-6);
    EXPECT_NEAR(engine->time(), 2010e-7, 1e-18);
}

// A slow piston lifts a particle: its work is what the particle gains and loses.
TEST(MovingWalls, WorkOfALiftIsTheWeightTimesTheWay) {
    EngineScene scene = with_walls({plane("base", {}, {0, 0, 1})});
    add_particle(scene.particles, {0, 0, paper_radius});
    const auto engine = scene.engine();
    engine->advance(2000);
    const double before = balance(engine->ledger());
    const double height = engine->particles().position[0].z;
    engine->set_wall_velocity(0, {0, 0, 0.01});
    engine->advance(20000);
    const EnergyLedger ledger = engine->ledger();
    const double weight = 2.844339083698e-9, lifted = 0.01 * 20000e-7;
    EXPECT_NEAR(engine->particles().position[0].z - height, lifted, 1e-4 * lifted);
    // The sudden start gives the particle m v by an impact; half of that work is lost in it.
    const double start = weight / paper_gravity * 1e-4;
    EXPECT_NEAR(ledger.wall_work, weight * lifted + start, 1e-3 * weight * lifted);
    EXPECT_NEAR(balance(ledger), before, 0.005 * ledger.wall_work);
}

// What a wall's contacts held goes with it, and the ledger says so.
TEST(MovingWalls, ARemovedWallTakesItsEnergyAlong) {
    for (const double bond : {0.0, 50.0}) {
        EngineScene scene{paper_setup(bond), {}, {plane("base", {}, {0, 0, 1}), plane("gate", {}, {1, 0, 0})}};
        add_particle(scene.particles, {paper_radius - 5e-9, 0, paper_radius - 3e-9});
        const auto engine = scene.engine();
        engine->advance(3);
        const EnergyLedger before = engine->ledger();
        ASSERT_EQ(engine->contacts().size(), 2u);
        engine->remove_wall(1);
        const EnergyLedger after = engine->ledger();
        EXPECT_EQ(engine->contacts().size(), 1u);
        EXPECT_FALSE(engine->walls()[1].active);
        EXPECT_GT(std::fabs(after.removed_with_walls), 0);
        // The friction spring of the gate counts as lost to friction.
        const double spring = before.elastic_tangential - after.elastic_tangential;
        EXPECT_GT(spring, 0);
        EXPECT_NEAR(before.stored() - after.stored(), after.removed_with_walls + spring,
                    1e-12 * std::fabs(before.stored()));
        EXPECT_NEAR(balance(before), balance(after), 1e-12 * std::fabs(before.stored()));
        EXPECT_LT(after.elastic_normal, before.elastic_normal);
        EXPECT_EQ(after.cohesion > before.cohesion, bond > 0);
        // The gate is gone: the particle flies through where it was.
        engine->advance(2000);
        EXPECT_DOUBLE_EQ(engine->ledger().removed_with_walls, after.removed_with_walls);
    }
}

}  // namespace
}  // namespace recoat
