#include <cmath>

#include <gtest/gtest.h>

#include "tests/solver/engine/engine_scenes.hpp"

namespace recoat {
namespace {

using namespace testing;

// Friction turns what rolling resistance holds: at rest nothing is lost.
TEST(RollingResistance, TakesNothingFromASphereThatStands) {
    EngineScene scene{paper_setup(400), {}, {plane("base", {}, {0, 0, 1})}};
    scene.setup.time_step = 2e-8;
    scene.setup.model.rolling_friction = 0.3;
    const double tilt = 0.05;
    scene.setup.gravity = paper_gravity * Vec3{std::sin(tilt), 0, -std::cos(tilt)};
    add_particle(scene.particles, {0, 0, paper_radius});
    const auto engine = scene.engine();
    engine->advance(100000);
    const EnergyLedger before = engine->ledger();
    const double place = engine->particles().position[0].x;
    engine->advance(200000);
    const EnergyLedger after = engine->ledger();
    EXPECT_NEAR(engine->particles().position[0].x, place, 1e-9 * dp) << "it should stand";
    EXPECT_LT(after.dissipated_rolling - before.dissipated_rolling, 1e-6 * before.elastic_normal);
    EXPECT_NEAR(balance(after), balance(before), 1e-6 * before.elastic_normal);
}

// Two spheres rolling on each other come to rest, and give what they had to rolling resistance and friction.
TEST(RollingResistance, OfTheRelativeSpinStopsAPair) {
    EngineScene scene{paper_setup(400), {}, {}};
    scene.setup.time_step = 2e-8;
    scene.setup.gravity = {};
    scene.setup.model.rolling_form = RollingForm::relative;
    scene.setup.model.rolling_friction = 1;
    add_particle(scene.particles, {});
    add_particle(scene.particles, {0, 0, dp - 1e-12});
    const auto rest = scene.engine();
    rest->advance(200000);
    scene.particles = rest->particles();
    scene.particles.velocity.assign(2, {});
    scene.particles.angular_velocity = {{0, 1, 0}, {0, -1, 0}};
    const auto engine = scene.engine();
    const EnergyLedger before = engine->ledger();
    const double spinning = before.kinetic_rotation;
    engine->advance(2000);
    for (const Vec3 spin : engine->particles().angular_velocity) EXPECT_LT(norm(spin), 1e-3);
    const EnergyLedger after = engine->ledger();
    EXPECT_NEAR(after.dissipated_rolling, spinning, 0.02 * spinning);
    EXPECT_NEAR(balance(after), balance(before), 0.01 * spinning);
}

// A particle in a cage of others cannot be stopped more than once by all of them together.
TEST(RollingResistance, OfTheRelativeSpinIsSharedByTheContacts) {
    EngineScene scene = busy_box({200, RollingForm::relative, 1, 200});
    scene.setup.model.rolling_friction = 2;
    scene.setup.model.restitution = 0.1;
    scene.setup.time_step = 5e-8;
    const auto engine = scene.engine();
    engine->advance(20000);
    const EnergyLedger before = engine->ledger();
    engine->advance(20000);
    const EnergyLedger after = engine->ledger();
    EXPECT_GT(after.dissipated_rolling - before.dissipated_rolling, 1e-3 * before.kinetic_rotation);
    EXPECT_NEAR(balance(after), balance(before), 0.01 * before.kinetic_rotation);
}

}  // namespace
}  // namespace recoat
