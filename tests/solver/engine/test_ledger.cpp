#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "tests/solver/engine/engine_scenes.hpp"

namespace recoat {
namespace {

using namespace testing;

/// Particles that fall into a heap in a narrow box.
EngineScene settling_box(const Variety& variety) {
    EngineScene scene;
    scene.setup = paper_setup(variety.bond);
    scene.setup.model.rolling_form = variety.rolling;
    scene.setup.time_step = 5e-8;
    scene.setup.gravity = {0, 0, -400};  // so that they settle within a short test
    scene.setup.y_period = 5 * dp;
    scene.particles = random_packing(120, {5 * dp, 5 * dp, 9 * dp}, variety.spread, true, 17);
    scene.walls = {plane("base", {}, {0, 0, 1}), plane("left", {}, {1, 0, 0}),
                   plane("right", {5 * dp, 0, 0}, {-1, 0, 0})};
    return scene;
}

class Ledger : public ::testing::TestWithParam<Variety> {};

TEST_P(Ledger, BalancesWhileABoxSettles) {
    const auto engine = settling_box(GetParam()).engine();
    const EnergyLedger start = engine->ledger();
    for (int portion = 0; portion < 5; ++portion) {
        engine->advance(8000);
        const EnergyLedger now = engine->ledger();
        EXPECT_NEAR(balance(now), balance(start), 0.01 * now.dissipated()) << "step " << engine->step();
    }
    const EnergyLedger end = engine->ledger();
    EXPECT_LT(engine->kinetic_energy(), 0.05 * end.dissipated());
    EXPECT_GT(end.dissipated(), 0.5 * start.stored());
    EXPECT_EQ(end.wall_work, 0);
}

// No mechanism gives energy back but the friction spring, whose store may shrink while its load does.
TEST_P(Ledger, NothingIsGained) {
    const auto engine = settling_box(GetParam()).engine();
    EnergyLedger last = engine->ledger();
    for (int portion = 0; portion < 20; ++portion) {
        engine->advance(500);
        const EnergyLedger now = engine->ledger();
        EXPECT_GE(now.dissipated_rolling, last.dissipated_rolling);
        EXPECT_GE(now.dissipated_tangential, 0);
        EXPECT_GE(now.dissipated_normal, 0);
        EXPECT_GE(now.elastic_normal, 0);
        EXPECT_GE(now.elastic_tangential, 0);
        EXPECT_LE(now.cohesion, 0);
        last = now;
    }
}

INSTANTIATE_TEST_SUITE_P(Varieties, Ledger, ::testing::ValuesIn(varieties));

TEST(Ledger, StoresWhatTheParticlesHave) {
    EngineScene scene{paper_setup(), {}, {}};
    add_particle(scene.particles, {0, 0, 0.1}, {0.3, 0.4, 0}, {0, 2000, 0});
    const EnergyLedger ledger = scene.engine()->ledger();
    const double mass = 2.899428219876e-10, inertia = 7.248570549689e-20;
    EXPECT_NEAR(ledger.kinetic_translation, 0.5 * mass * 0.25, 1e-12 * mass);
    EXPECT_NEAR(ledger.kinetic_rotation, 0.5 * inertia * 4e6, 1e-12 * inertia * 4e6);
    EXPECT_NEAR(ledger.gravity, mass * 9.81 * 0.1, 1e-12 * mass);
    EXPECT_EQ(ledger.elastic_normal, 0);
    EXPECT_EQ(ledger.cohesion, 0);
    EXPECT_EQ(ledger.dissipated(), 0);
}

/// Largest imbalance of energy, over what the piston gives in all, while it strikes a spinning sphere askew: looked at
/// every 4e-7 s, from before the impact to after it.
double imbalance_in_an_impact(const Variety& variety, double time_step) {
    EngineScene scene{paper_setup(variety.bond), {}, {plane("piston", {}, {0, 0, 1})}};
    scene.setup.time_step = time_step;
    scene.setup.gravity = {};
    scene.setup.model.rolling_form = variety.rolling;
    scene.setup.model.rolling_friction = 0.1;
    add_particle(scene.particles, {0, 0, paper_radius + 1e-8}, {}, {200, -300, 100});
    const auto engine = scene.engine();
    const double start = balance(engine->ledger());
    engine->set_wall_velocity(0, {0.03, 0, 0.05});
    double worst = 0;
    for (int look = 0; look < 20; ++look) {
        engine->advance(std::lround(4e-7 / time_step));
        worst = std::max(worst, std::fabs(balance(engine->ledger()) - start));
    }
    return worst / engine->ledger().wall_work;
}

// Powers are those at the positions, added up by the trapezoidal rule: the ledger closes at any moment, also of an
// impact that is under way, with an error of second order.
TEST(Ledger, ClosesInTheMiddleOfAnImpact) {
    for (const Variety& variety : {Variety{0, RollingForm::own}, Variety{0, RollingForm::relative},
                                   Variety{5, RollingForm::own}, Variety{5, RollingForm::relative}}) {
        const double coarse = imbalance_in_an_impact(variety, 1e-7), fine = imbalance_in_an_impact(variety, 2.5e-8);
        EXPECT_LT(coarse, 2e-3) << name_of(variety);
        EXPECT_LT(fine, coarse / 8) << name_of(variety);
    }
}

// A wall that changes its velocity during an impact does so between two steps, the second of which is whole: an error
// of first order, once.
TEST(Ledger, ClosesAfterAWallChangedItsVelocity) {
    const auto imbalance = [](double time_step) {
        EngineScene scene{paper_setup(), {}, {plane("piston", {}, {0, 0, 1})}};
        scene.setup.time_step = time_step;
        scene.setup.gravity = {};
        add_particle(scene.particles, {0, 0, paper_radius});
        const auto engine = scene.engine();
        engine->set_wall_velocity(0, {0.03, 0, 0.05});
        engine->advance(std::lround(2e-6 / time_step));
        const double before = balance(engine->ledger());
        engine->set_wall_velocity(0, {0, 0, 0.03});
        engine->advance(std::lround(1e-5 / time_step));
        EXPECT_TRUE(engine->contacts().empty());
        return std::fabs(balance(engine->ledger()) - before) / engine->ledger().wall_work;
    };
    const double coarse = imbalance(1e-7), fine = imbalance(2.5e-8);
    EXPECT_LT(coarse, 0.02);
    EXPECT_LT(fine, coarse / 3);
}

// Newton's third law in the contacts: what the particles of a free cluster have in total stays.
TEST(Ledger, MomentumOfAFreeClusterStays) {
    for (const Variety& variety : varieties) {
        EngineScene scene{paper_setup(variety.bond),
                          random_packing(150, {7.5 * dp, 7.5 * dp, 7.5 * dp}, variety.spread, false, 23),
                          {}};
        scene.setup.model.rolling_form = variety.rolling;
        scene.setup.gravity = {};
        const auto momentum = [&](const ParticleTable& table) {
            Vec3 sum{};
            for (std::size_t i = 0; i < table.size(); ++i)
                sum += sphere_mass(table.radius[i], 4430) * table.velocity[i];
            return sum;
        };
        const auto engine = scene.engine();
        engine->advance(2000);
        EXPECT_GT(engine->largest_overlap(), 1e-5);
        const double scale = 150 * 2.9e-10 * 0.1;
        EXPECT_LT(norm(momentum(engine->particles()) - momentum(scene.particles)), 1e-6 * scale) << name_of(variety);
    }
}

}  // namespace
}  // namespace recoat
