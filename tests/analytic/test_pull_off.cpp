#include <cmath>
#include <memory>
#include <string>

#include <gtest/gtest.h>

#include "tests/support/small_scene.hpp"

namespace recoat {
namespace {

using testing::pair_separation;
using testing::SmallScene;
namespace powder = testing::powder;

/// Gravity, as a multiple of `unit`, at which `separation` first exceeds twenty times the minimum separation, when it
/// grows evenly to 2 in 4 ms [docs/physics.md section 2.6]. Gravity changes between steps: the state goes on.
template <class Separation>
double pull_off(SmallScene scene, double unit, const Separation& separation) {
    constexpr double duration = 4e-3;
    const std::int64_t part = 40;
    auto engine = scene.engine();
    for (;;) {
        const double load = 2 * engine->time() / duration;
        if (load > 2) return load;
        scene.setup.gravity = {0, 0, -load * unit};
        engine = restore_engine(scene.setup, engine->save());
        engine->advance(part);
        if (separation(engine->particles()) > 20 * scene.setup.model.minimum_separation) return load;
    }
}

/// A sphere under a ceiling at z = 0: the wall holds 2 Bo weights.
SmallScene under_ceiling(const ContactModel& model, double time_step, double bond) {
    SmallScene scene(model, time_step);
    const double force = 2 * bond * powder::weight * attraction_scaling(model.stiffness_ratio);
    const double overlap = std::cbrt(std::pow(force / powder::hertz(model.stiffness_ratio, powder::radius), 2));
    scene.plane({0, 0, 0}, {0, 0, -1});
    scene.sphere({0, 0, -powder::radius + overlap});
    return scene;
}

/// A sphere in a slot between two boxes, and one that hangs from it below them, clear of the boxes.
SmallScene hanging_from_slot(const ContactModel& model, double time_step, double bond) {
    SmallScene scene(model, time_step);
    const double r = powder::radius, half_width = 0.8 * r, thickness = 0.2 * r;
    const double force = bond * powder::weight * attraction_scaling(model.stiffness_ratio);
    const double overlap = std::cbrt(std::pow(force / powder::hertz(model.stiffness_ratio, 0.5 * r), 2));
    scene.box({half_width, -1, -thickness}, {1, 1, 0});
    scene.box({-1, -1, -thickness}, {-half_width, 1, 0});
    const double height = 0.6 * r;  // sqrt(1 - 0.8^2): the sphere touches both edges
    scene.sphere({0, 0, height});
    scene.sphere({0, 0, height - 2 * r + overlap});
    return scene;
}

class PullOff : public ::testing::TestWithParam<int> {};

double wall_pull_off(const ContactModel& model, double time_step, double bond) {
    return pull_off(under_ceiling(model, time_step, bond), 2 * bond * powder::gravity,
                    [](const ParticleTable& p) { return -p.position[0].z - p.radius[0]; });
}

double pair_pull_off(const ContactModel& model, double time_step, double bond) {
    return pull_off(hanging_from_slot(model, time_step, bond), bond * powder::gravity, pair_separation);
}

// docs/physics.md section 2.6: the discrete gradient holds the original pull-off force, whatever ratio and step.
TEST_P(PullOff, of_a_wall_is_twice_the_bond_number) {
    for (const double ratio : {0.1, 0.01, 0.001}) {
        const double found = wall_pull_off(powder::model(ratio, GetParam()), 2e-8, GetParam());
        EXPECT_NEAR(found, 1, 0.03) << ratio;
        RecordProperty("ratio" + std::to_string(ratio), std::to_string(found));
    }
    for (const double time_step : {5e-8, 1e-7, 2e-7}) {
        const double found = wall_pull_off(powder::model(0.001, GetParam()), time_step, GetParam());
        EXPECT_NEAR(found, 1, 0.03) << time_step;
        RecordProperty("step" + std::to_string(1e9 * time_step), std::to_string(found));
    }
}

TEST_P(PullOff, of_a_pair_is_the_bond_number) {
    for (const double ratio : {0.1, 0.001}) {
        const double found = pair_pull_off(powder::model(ratio, GetParam()), 2e-8, GetParam());
        EXPECT_NEAR(found, 1, 0.03) << ratio;
        RecordProperty("ratio" + std::to_string(ratio), std::to_string(found));
    }
    for (const double time_step : {5e-8, 1e-7}) {
        const double found = pair_pull_off(powder::model(0.001, GetParam()), time_step, GetParam());
        EXPECT_NEAR(found, 1, 0.03) << time_step;
        RecordProperty("step" + std::to_string(1e9 * time_step), std::to_string(found));
    }
}

INSTANTIATE_TEST_SUITE_P(BondNumber, PullOff, ::testing::Values(5, 50, 400),
                         [](const auto& bond) { return "bond_" + std::to_string(bond.param); });

// Section 2.6: the plain force lets go early, and the reduced Hamaker constant out of contact at r^(2/5) of the force.
TEST(PullOffSchemes, that_are_not_exact_let_go_early) {
    ContactModel model = powder::model(0.001, 400);
    model.scheme = CohesionScheme::explicit_force;
    EXPECT_LT(wall_pull_off(model, 2e-8, 400), 0.8);
    EXPECT_LT(wall_pull_off(model, 1e-7, 400), 0.3);
    model.non_contact = NonContactHamaker::reduced;
    EXPECT_NEAR(pair_pull_off(model, 2e-8, 400), attraction_scaling(0.001), 0.02);
}

}  // namespace
}  // namespace recoat
