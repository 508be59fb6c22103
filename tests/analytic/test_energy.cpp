#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "tests/support/reference.hpp"
#include "tests/support/small_scene.hpp"

namespace recoat {
namespace {

using testing::head_on_pair;
using testing::over_plane;
using testing::pair_rate;
using testing::SmallScene;
namespace powder = testing::powder;

double kinetic(const EnergyLedger& ledger) { return ledger.kinetic_translation + ledger.kinetic_rotation; }

/// Energy that has appeared from nowhere since the start, over the kinetic energy of the start.
double imbalance(const SmallScene& scene, std::int64_t steps) {
    const auto engine = scene.engine();
    const EnergyLedger start = engine->ledger();
    engine->advance(steps);
    EXPECT_GT(engine->largest_overlap(), 1e-5) << "there was no contact";
    const EnergyLedger end = engine->ledger();
    return (end.stored() + end.dissipated() - end.wall_work - start.stored()) / kinetic(start);
}

SmallScene oblique_on_plane(const ContactModel& model) {
    return over_plane(model, 2e-8, 5e-9, {0.04, 0.01, -0.05}, {300, -400, 200});
}

SmallScene oblique_pair(const ContactModel& model) {
    SmallScene scene = head_on_pair(model, 2e-8, 5e-9, 0.1);
    scene.particles.velocity[0].y = 0.03;
    scene.particles.angular_velocity = {{300, -400, 200}, {100, 500, 700}};
    return scene;
}

ContactModel frictionless(double bond = 0) {
    ContactModel model = powder::model(0.001, bond);
    model.sliding_friction = model.rolling_friction = 0;
    return model;
}

// docs/physics.md section 5.6: without damping the stored energy stays, through the contact too.
TEST(Energy, of_an_undamped_impact_stays) {
    ContactModel model = frictionless();
    model.restitution = 1;
    const auto engine = head_on_pair(model, 2e-8, 5e-9, 0.1).engine();
    const double start = engine->ledger().stored();
    double worst = 0;
    for (int step = 0; step < 500; ++step) {
        engine->advance(1);
        worst = std::max(worst, std::fabs(engine->ledger().stored() / start - 1));
    }
    EXPECT_LT(worst, 1e-3);
    EXPECT_NEAR(engine->ledger().stored() / start, 1, 2e-5);
    EXPECT_EQ(engine->ledger().dissipated(), 0);
}

TEST(Energy, of_a_damped_impact_goes_to_the_normal_dashpot) {
    const auto engine = head_on_pair(frictionless(), 2e-8, 5e-9, 0.1).engine();
    const double start = kinetic(engine->ledger());
    engine->advance(1000);
    EXPECT_NEAR(engine->ledger().dissipated_normal / start, 1 - 0.16, 1e-3);
    EXPECT_EQ(engine->ledger().dissipated_tangential, 0);
    EXPECT_NEAR(imbalance(head_on_pair(frictionless(), 2e-8, 5e-9, 0.1), 1000), 0, 1e-3);
}

// Friction, rolling and attraction, on a wall and between spheres.
TEST(Energy, balances_in_every_kind_of_impact) {
    for (const RollingForm form : {RollingForm::own, RollingForm::relative})
        for (const double bond : {0.0, 5.0, 400.0}) {
            ContactModel model = powder::model(0.001, bond);
            model.rolling_form = form;
            EXPECT_NEAR(imbalance(oblique_on_plane(model), 2000), 0, 1e-3) << bond;
            EXPECT_NEAR(imbalance(oblique_pair(model), 2000), 0, 1e-3) << bond;
            model.rolling_friction = 0.2;
            EXPECT_NEAR(imbalance(oblique_on_plane(model), 2000), 0, 2e-3) << bond;
            EXPECT_NEAR(imbalance(oblique_pair(model), 2000), 0, 2e-3) << bond;
        }
}

// A sphere that slides and rolls to rest: all of its energy is found again in the mechanisms.
TEST(Energy, of_a_sphere_that_stops_is_found_again) {
    for (const double bond : {50.0, 400.0}) {
        SmallScene scene = over_plane(powder::model(0.001, bond), 2e-8, 0, {0.05, 0, 0});
        scene.setup.gravity = {0, 0, -powder::gravity};
        const auto engine = scene.engine();
        const EnergyLedger start = engine->ledger();
        engine->advance(400000);
        const EnergyLedger end = engine->ledger();
        EXPECT_LT(kinetic(end), 1e-9 * kinetic(start));
        EXPECT_NEAR((end.stored() + end.dissipated() - start.stored()) / kinetic(start), 0, 2e-3) << bond;
        EXPECT_GT(end.dissipated_rolling, 0.3 * kinetic(start));
        EXPECT_GT(end.dissipated_tangential, 0.2 * kinetic(start));
    }
}

// Section 5.6: with e = 1 a pair leaves iff its energy is above that of rest far away, and as fast as it came.
TEST(Energy, of_a_cohesive_elastic_pair_decides_on_escape) {
    ContactModel model = frictionless(400);
    model.restitution = 1;
    for (const double speed : {5e-4, 2e-3, 0.01, 0.05}) {
        const auto engine = head_on_pair(model, 2e-8, 1.01 * model.cut_off, speed).engine();
        const ParticleTable after = testing::after_impact(
            *engine, [&](const ParticleTable& p) { return testing::pair_separation(p) - model.cut_off; }, pair_rate);
        EXPECT_NEAR(pair_rate(after) / speed, 1, speed < 1e-3 ? 0.03 : 0.003) << speed;
    }
    // Bound: from rest within the range it never gets beyond where it started.
    const auto bound = head_on_pair(model, 2e-8, 1e-9, 0).engine();
    double farthest = 0;
    for (int k = 0; k < 20000; ++k) {
        bound->advance(5);
        farthest = std::max(farthest, testing::pair_separation(bound->particles()));
    }
    EXPECT_LT(farthest, 1.2e-9);
    EXPECT_GT(farthest, 0.8e-9);
}

// Section 2.6: twelve frictionless elastic spheres bound in a cluster; drift in units of the well of a pair.
TEST(Energy, of_a_bound_cluster_hardly_drifts) {
    ContactModel model = frictionless(400);
    model.restitution = 1;
    SmallScene scene(model, 2e-8);
    const double apart = powder::diameter + 2e-10;
    for (int layer = 0; layer < 3; ++layer)
        for (int k = 0; k < 4; ++k) {
            const double x = (k % 2) * apart, y = static_cast<double>(k) / 2 >= 1 ? apart : 0;
            scene.sphere({x, y, layer * apart}, {1e-4 * std::sin(k + 4 * layer), 1e-4 * std::cos(2 * k - layer), 0});
        }
    const auto engine = scene.engine();
    const double force = 400 * powder::weight, range = powder::minimum_separation;
    const double well = force * range * (2 - range / model.cut_off);
    const double start = engine->ledger().stored();
    double worst = 0;
    for (int part = 0; part < 100; ++part) {
        engine->advance(500);
        worst = std::max(worst, std::fabs(engine->ledger().stored() - start) / well);
    }
    EXPECT_LT(std::fabs(engine->ledger().stored() - start) / well, 0.05);
    EXPECT_LT(worst, 0.1);
    RecordProperty("worst_of_well", std::to_string(worst));
    RecordProperty("end_of_well", std::to_string((engine->ledger().stored() - start) / well));
}

}  // namespace
}  // namespace recoat
