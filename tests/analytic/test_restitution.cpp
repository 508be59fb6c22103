#include <string>

#include <gtest/gtest.h>

#include "tests/analytic/phases.hpp"
#include "tests/support/reference.hpp"
#include "tests/support/verification.hpp"

namespace recoat {
namespace {

using testing::over_phases;
using testing::pair_restitution;
using testing::reference;
using testing::verify;
using testing::wall_restitution;
namespace powder = testing::powder;

ContactModel with_restitution(double e) {
    ContactModel model = powder::model();
    model.restitution = e;
    return model;
}

void verify_restitution(const testing::Errors& errors, double e, const std::string& where) {
    // A dashpot this strong dies out late: the contact ends slowly, and a step late costs more.
    verify(e >= 0.4 ? "mean, absolute" : "mean at e < 0.4, absolute", errors.mean, e >= 0.4 ? 2e-4 : 1e-3, where);
    verify("worst, absolute", errors.worst(), 1e-3, where);
}

// docs/physics.md section 1.4: the restitution is the one asked for, at any speed.
TEST(Restitution, of_a_pair_is_exact_at_the_step_of_the_paper) {
    for (const double e : {0.1, 0.2, 0.4, 0.6, 0.8, 0.9, 1.0})
        for (const double speed : {0.01, 0.05, 0.5}) {
            const auto model = with_restitution(e);
            const auto errors =
                over_phases(8, [&](double phase) { return pair_restitution(model, 2e-8, speed, phase) - e; });
            verify_restitution(errors, e, std::to_string(e) + " at " + std::to_string(speed) + " m/s");
        }
}

TEST(Restitution, of_a_wall_impact_is_exact_at_the_step_of_the_paper) {
    for (const double e : {0.1, 0.2, 0.4, 0.6, 0.8, 0.9, 1.0}) {
        const auto model = with_restitution(e);
        const auto errors =
            over_phases(8, [&](double phase) { return wall_restitution(model, 2e-8, 0.05, phase) - e; });
        verify_restitution(errors, e, std::to_string(e));
    }
}

TEST(Restitution, with_the_force_clipped_is_the_larger_one_of_the_table) {
    for (const std::string e : {"0.1", "0.2", "0.4", "0.6", "0.8", "0.9"}) {
        ContactModel model = with_restitution(std::stod(e));
        model.clip_normal = true;
        const double expected = reference("restitution." + e + ".clipped");
        const auto errors =
            over_phases(8, [&](double phase) { return pair_restitution(model, 2e-8, 0.05, phase) - expected; });
        verify("mean, absolute", errors.mean, 1e-3, e);
    }
}

// Section 5.2 (Chung & Ooi test 3): 3.9 m/s, 2.5 mm radius, independent of the material.
TEST(Restitution, is_that_of_chung_and_ooi_test_3) {
    struct Material {
        double youngs_modulus, poisson_ratio, density;
    };
    for (const Material& material : {Material{3.8e11, 0.23, 4000}, Material{1e11, 0.25, 7000}})
        for (int tenths = 2; tenths <= 10; ++tenths) {
            ContactModel model;
            model.youngs_modulus = material.youngs_modulus;
            model.poisson_ratio = material.poisson_ratio;
            model.density = material.density;
            model.restitution = 0.1 * tenths;
            const auto errors = over_phases(
                4, [&](double phase) { return wall_restitution(model, 2e-8, 3.9, phase, 5e-3) - model.restitution; });
            verify("worst, absolute", errors.worst(), 1e-3, std::to_string(tenths) + " tenths");
        }
}

}  // namespace
}  // namespace recoat
