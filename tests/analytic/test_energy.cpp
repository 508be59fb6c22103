#include <algorithm>
#include <cmath>
#include <string>

#include <gtest/gtest.h>

#include "tests/support/small_scene.hpp"
#include "tests/support/verification.hpp"

namespace recoat {
namespace {

using testing::head_on_pair;
using testing::over_plane;
using testing::pair_rate;
using testing::SmallScene;
using testing::verify;
using testing::verify_relative;
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

/// Work of the attraction of a pair from touch to the cut-off [J] [docs/physics.md section 2.4].
double well_of_a_pair(const ContactModel& model) {
    const double range = model.minimum_separation;
    return 400 * powder::weight * range * (2 - range / model.cut_off);
}

// docs/physics.md section 5.6: without damping the stored energy stays, at 40, 80 and 160 steps per contact. In contact
// the sum of kinetic and elastic energy of a leapfrog swings by the square of the step; what is left after it is far
// less.
TEST(Energy, of_an_undamped_impact_stays) {
    struct Row {
        int steps;
        double after, within;
    };
    for (const Row& row : {Row{40, 1.44e-4, 8e-3}, Row{80, 2.6e-5, 2e-3}, Row{160, 4.4e-6, 5e-4}}) {
        ContactModel model = frictionless();
        model.restitution = 1;
        const double time_step = 3.892e-6 / row.steps;
        const std::string steps = " at " + std::to_string(row.steps) + " steps per contact";
        for (int phase = 0; phase < 8; ++phase) {
            const auto engine = head_on_pair(model, time_step, (3 + phase / 8.0) * 0.1 * time_step, 0.1).engine();
            const double start = engine->ledger().stored();
            for (int step = 0; step < row.steps + 10; ++step) {
                engine->advance(1);
                verify("within the contact" + steps, engine->ledger().stored() / start - 1, row.within);
            }
            EXPECT_EQ(engine->ledger().elastic_normal, 0) << "they should have parted";
            // Twice the error of the speed.
            verify("after the contact" + steps, engine->ledger().stored() / start - 1, row.after);
            EXPECT_EQ(engine->ledger().dissipated(), 0);
        }
    }
}

TEST(Energy, of_a_damped_impact_goes_to_the_normal_dashpot) {
    const auto engine = head_on_pair(frictionless(), 2e-8, 5e-9, 0.1).engine();
    const double start = kinetic(engine->ledger());
    engine->advance(1000);
    verify("lost over 1 - e^2", engine->ledger().dissipated_normal / start / (1 - 0.16) - 1, 1e-3);
    EXPECT_EQ(engine->ledger().dissipated_tangential, 0);
    verify("imbalance", imbalance(head_on_pair(frictionless(), 2e-8, 5e-9, 0.1), 1000), 1e-3);
}

// Friction, rolling and attraction, on a wall and between spheres.
TEST(Energy, balances_in_every_kind_of_impact) {
    for (const RollingForm form : {RollingForm::own, RollingForm::relative})
        for (const double bond : {0.0, 5.0, 400.0}) {
            ContactModel model = powder::model(0.001, bond);
            model.rolling_form = form;
            verify("imbalance", imbalance(oblique_on_plane(model), 2000), 3e-4, std::to_string(bond));
            verify("imbalance", imbalance(oblique_pair(model), 2000), 3e-4, std::to_string(bond));
            model.rolling_friction = 0.2;
            verify("imbalance with rolling friction 0.2", imbalance(oblique_on_plane(model), 2000), 3e-4,
                   std::to_string(bond));
            verify("imbalance with rolling friction 0.2", imbalance(oblique_pair(model), 2000), 3e-4,
                   std::to_string(bond));
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
        verify("imbalance", (end.stored() + end.dissipated() - start.stored()) / kinetic(start), 1e-4,
               std::to_string(bond));
        EXPECT_GT(end.dissipated_rolling, 0.3 * kinetic(start));
        EXPECT_GT(end.dissipated_tangential, 0.2 * kinetic(start));
    }
}

// Section 5.6: with e = 1 a pair leaves iff its energy is above that of rest far away, and as fast as it came. The
// energy is counted in wells: what a slow pair has left is a small part of that.
TEST(Energy, of_a_cohesive_elastic_pair_decides_on_escape) {
    ContactModel model = frictionless(400);
    model.restitution = 1;
    const double escape_energy = well_of_a_pair(model) / (0.25 * powder::mass);
    for (const double speed : {2e-4, 5e-4, 2e-3, 0.01, 0.05})
        for (int phase = 0; phase < 8; ++phase) {
            const double start = model.cut_off + phase / 8.0 * speed * 2e-8;
            const auto engine = head_on_pair(model, 2e-8, start, speed).engine();
            const ParticleTable after = testing::after_impact(
                *engine, [&](const ParticleTable& p) { return testing::pair_separation(p) - model.cut_off; },
                pair_rate);
            const double out = pair_rate(after), gain = (out * out - speed * speed) / (speed * speed + escape_energy);
            verify("energy far away over that at touch", gain, 4.4e-6, std::to_string(speed));
            if (speed >= 0.01) verify_relative("speed far away", out, speed, 2.2e-6);
        }
    // Bound: from rest within the range it never gets beyond where it started.
    for (const double start : {2e-10, 1e-9, 5e-9}) {
        const auto bound = head_on_pair(model, 2e-8, start, 0).engine();
        double farthest = 0;
        for (int k = 0; k < 20000; ++k) {
            bound->advance(5);
            farthest = std::max(farthest, testing::pair_separation(bound->particles()));
        }
        const double range = powder::minimum_separation;
        const auto depth = [&](double s) { return range / s; };  // of the potential, over that at s_min
        verify("energy at the farthest point of a bound pair, in wells",
               0.5 * (depth(start) - depth(std::max(farthest, range))), 2e-5, std::to_string(start));
    }
}

// Section 2.6: twelve frictionless elastic spheres bound in a cluster for 1 ms; drift in units of the well of a pair.
TEST(Energy, of_a_bound_cluster_hardly_drifts) {
    for (const double time_step : {2e-8, 1e-7}) {
        ContactModel model = frictionless(400);
        model.restitution = 1;
        SmallScene scene(model, time_step);
        const double apart = powder::diameter + 2e-10;
        for (int layer = 0; layer < 3; ++layer)
            for (int k = 0; k < 4; ++k) {
                const double x = (k % 2) * apart, y = k >= 2 ? apart : 0;
                scene.sphere({x, y, layer * apart},
                             {1e-4 * std::sin(k + 4 * layer), 1e-4 * std::cos(2 * k - layer), 0});
            }
        const auto engine = scene.engine();
        const double start = engine->ledger().stored(), well = well_of_a_pair(model);
        const bool fine = time_step == 2e-8;
        const std::string step = fine ? " at 2e-8 s" : " at 1e-7 s";
        for (int part = 0; part < 100; ++part) {
            engine->advance(std::lround(1e-5 / time_step));
            verify("wells, at any time" + step, (engine->ledger().stored() - start) / well, fine ? 0.01 : 0.06);
        }
        verify("wells, after 1 ms" + step, (engine->ledger().stored() - start) / well, fine ? 0.01 : 0.02);
    }
}

}  // namespace
}  // namespace recoat
