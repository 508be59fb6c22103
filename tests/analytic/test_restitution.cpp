#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "tests/support/reference.hpp"
#include "tests/support/small_scene.hpp"

namespace recoat {
namespace {

using testing::after_pair_impact;
using testing::after_plane_impact;
using testing::head_on_pair;
using testing::over_plane;
using testing::pair_rate;
using testing::reference;
namespace powder = testing::powder;

/// Mean restitution over sub-step phases of the first touch, and its largest deviation from `expected`.
struct Measured {
    double mean = 0, worst = 0;
};

template <class Impact>
Measured over_phases(int phases, double expected, const Impact& impact) {
    Measured measured;
    for (int k = 0; k < phases; ++k) {
        const double e = impact((k + 0.5) / phases);
        measured.mean += e / phases;
        measured.worst = std::max(measured.worst, std::fabs(e - expected));
    }
    return measured;
}

double pair_restitution(const ContactModel& model, double time_step, double speed, double phase) {
    const auto scene = head_on_pair(model, time_step, (3 + phase) * speed * time_step, speed);
    return pair_rate(after_pair_impact(*scene.engine())) / speed;
}

double wall_restitution(const ContactModel& model, double time_step, double speed, double phase) {
    const auto scene = over_plane(model, time_step, (3 + phase) * speed * time_step, {0, 0, -speed});
    return after_plane_impact(*scene.engine()).velocity[0].z / speed;
}

ContactModel with_restitution(double e) {
    ContactModel model = powder::model();
    model.restitution = e;
    return model;
}

// docs/physics.md section 1.4: the restitution is the one asked for, at any speed.
TEST(Restitution, of_a_pair_is_exact_at_the_step_of_the_paper) {
    for (const double e : {0.1, 0.2, 0.4, 0.6, 0.8, 0.9, 1.0})
        for (const double speed : {0.01, 0.05, 0.5}) {
            const auto found = over_phases(
                8, e, [&](double phase) { return pair_restitution(with_restitution(e), 2e-8, speed, phase); });
            EXPECT_NEAR(found.mean, e, e >= 0.4 ? 2e-4 : 1e-3) << e << " at " << speed << " m/s";
            EXPECT_LT(found.worst, 1e-3) << e << " at " << speed << " m/s";
        }
}

TEST(Restitution, of_a_wall_impact_is_exact_at_the_step_of_the_paper) {
    for (const double e : {0.1, 0.2, 0.4, 0.6, 0.8, 0.9, 1.0}) {
        const auto found =
            over_phases(8, e, [&](double phase) { return wall_restitution(with_restitution(e), 2e-8, 0.05, phase); });
        EXPECT_NEAR(found.mean, e, e >= 0.4 ? 2e-4 : 1e-3) << e;
        EXPECT_LT(found.worst, 1e-3) << e;
    }
}

// Section 4.2: 45 steps per contact.
TEST(Restitution, holds_at_larger_steps) {
    const auto found =
        over_phases(32, 0.4, [](double phase) { return pair_restitution(powder::model(), 1e-7, 0.05, phase); });
    EXPECT_NEAR(found.mean, 0.4, 1e-3);
    EXPECT_LT(found.worst, 4e-3);
}

TEST(Restitution, error_falls_with_the_step) {
    double before = 1;
    for (const double time_step : {8e-8, 4e-8, 2e-8, 1e-8}) {
        const auto found = over_phases(
            32, 0.4, [&](double phase) { return pair_restitution(powder::model(), time_step, 0.05, phase); });
        EXPECT_LT(found.worst, 0.7 * before) << time_step;
        before = found.worst;
    }
}

TEST(Restitution, with_the_force_clipped_is_the_larger_one_of_the_table) {
    for (const std::string e : {"0.1", "0.2", "0.4", "0.6", "0.8", "0.9"}) {
        ContactModel model = with_restitution(std::stod(e));
        model.clip_normal = true;
        const double expected = reference("restitution." + e + ".clipped");
        const auto found =
            over_phases(8, expected, [&](double phase) { return pair_restitution(model, 2e-8, 0.05, phase); });
        EXPECT_NEAR(found.mean, expected, 1e-3) << e;
    }
}

// Section 5.2 (Chung & Ooi test 3): independent of the material.
TEST(Restitution, is_that_of_chung_and_ooi_test_3) {
    struct Material {
        double youngs_modulus, poisson_ratio, density;
    };
    for (const Material& material : {Material{3.8e11, 0.23, 4000}, Material{1e11, 0.25, 7000}})
        for (const double e : {0.2, 0.4, 0.6, 0.8, 1.0}) {
            ContactModel model;
            model.youngs_modulus = material.youngs_modulus;
            model.poisson_ratio = material.poisson_ratio;
            model.density = material.density;
            model.restitution = e;
            const auto scene = over_plane(model, 2e-8, 1e-6, {0, 0, -3.9}, {}, 5e-3);
            EXPECT_NEAR(after_plane_impact(*scene.engine()).velocity[0].z / 3.9, e, 1e-3);
        }
}

// Section 5.6: undamped impacts, worst over the phases at 40, 80 and 160 steps per contact.
TEST(Restitution, of_undamped_impacts_converges_at_the_order_of_the_table) {
    constexpr double duration = 4.471e-6;  // of a pair at 0.05 m/s without damping, section 4.1
    const std::vector<std::pair<double, double>> table = {{40, 7.2e-5}, {80, 1.3e-5}, {160, 2.2e-6}};
    for (const auto& [steps, largest] : table) {
        const auto found = over_phases(32, 1.0, [&, n = steps](double phase) {
            return pair_restitution(with_restitution(1), duration / n, 0.05, phase);
        });
        EXPECT_LT(found.worst, 1.05 * largest) << steps;
        EXPECT_GT(found.worst, 0.5 * largest) << steps;
    }
}

}  // namespace
}  // namespace recoat
