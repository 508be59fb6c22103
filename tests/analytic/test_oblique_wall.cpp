#include <cmath>
#include <numbers>
#include <string>
#include <utility>

#include <gtest/gtest.h>

#include "tests/analytic/oblique_impact.hpp"
#include "tests/support/reference.hpp"
#include "tests/support/verification.hpp"

namespace recoat {
namespace {

using testing::frictional;
using testing::ObliqueImpact;
using testing::reference;
using testing::shortest;
using testing::verify;
using testing::verify_relative;
namespace powder = testing::powder;

constexpr double degree = std::numbers::pi / 180;

/// The impact at `steps` steps per elastic contact.
ObliqueImpact impact(const ContactModel& model, double radius, double normal_speed, int steps) {
    return {model, radius, normal_speed, testing::elastic_duration(model, radius, normal_speed) / steps};
}

// docs/physics.md section 5.5, Chung & Ooi test 4: column MD.
TEST(ObliqueWall, is_chung_and_ooi_test_4) {
    const ContactModel oxide = frictional(3.8e11, 0.23, 4000, 0.98, 0.092);
    for (const int angle : {5, 10, 15, 20, 25, 30, 40, 60, 80}) {
        const double tangential = 3.9 * std::sin(angle * degree), normal = 3.9 * std::cos(angle * degree);
        const auto found = impact(oxide, 2.5e-3, normal, 1000).run(tangential);
        const auto expected = [&](const char* what) { return reference("oxide." + std::to_string(angle) + what); };
        const std::string where = std::to_string(angle) + " degrees";
        verify_relative("tangential restitution", found.tangential / tangential, expected(".restitution"), 1e-3, where);
        verify_relative("spin", found.spin / 2.5e-3, expected(".spin"), 1e-3, where);
        verify("angle of rebound [degrees]", std::atan(found.surface() / found.normal) / degree - expected(".rebound"),
               0.01, where);
        if (angle < 30) continue;
        const double closed_form = 1 - 0.092 * 1.98 / std::tan(angle * degree);
        verify_relative("tangential restitution while sliding", found.tangential / tangential, closed_form, 1e-5,
                        where);
        verify_relative("spin while sliding", found.spin, -2.5 * 0.092 * 1.98 * normal, 2e-5, where);
    }
}

// Test 5: in units of mu v_n.
TEST(ObliqueWall, is_chung_and_ooi_test_5) {
    const std::pair<const char*, ContactModel> cases[] = {{"steel", frictional(2.08e11, 0.3, 7850, 1, 0.3)},
                                                          {"polyethylene", frictional(1e9, 0.4, 1400, 1, 0.3)}};
    const double unit = 0.3 * 5;
    for (const auto& [name, model] : cases)
        for (const double x : {0.6764, 1.0, 1.68, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0, 10.0, 13.0}) {
            const auto found = impact(model, 1e-5, 5, 1000).run(x * unit);
            const std::string where = std::string(name) + "." + shortest(x);
            verify("recoil of the surface over mu v_n", found.surface() / unit - reference(where + ".recoil"), 1e-3,
                   where);
            verify("spin over mu v_n", found.spin / unit - reference(where + ".spin"), 1e-3, where);
            if (x < 6) continue;
            verify("recoil while sliding over mu v_n", found.surface() / unit - (x - 7), 5e-9, where);
            verify("spin while sliding over mu v_n", found.spin / unit + 5, 5e-9, where);
        }
}

// The paper's powder on a wall: with the tangential dashpot and without, at the paper's step and at a quarter.
TEST(ObliqueWall, of_the_powder_is_that_of_the_reference) {
    for (const bool damped : {true, false})
        for (const double time_step : {2e-8, 5e-9}) {
            ContactModel model = powder::model();
            model.tangential_damping = damped ? TangentialDamping::as_normal : TangentialDamping::none;
            model.rolling_friction = 0;
            const ObliqueImpact impact{model, powder::radius, 0.05, time_step};
            const std::string step = time_step == 2e-8 ? " at 2e-8 s" : " at 5e-9 s";
            const std::string kind = damped ? "powder.damped." : "powder.undamped.";
            for (const double x : {0.1, 0.3, 0.5, 1.0, 2.0}) {
                const auto found = impact.run(0.05 * x);
                const std::string where = kind + shortest(x);
                verify("recoil of the surface over v_n" + step, found.surface() / 0.05 - reference(where + ".recoil"),
                       1e-3, where);
                verify("tangential impulse over m v_n" + step,
                       found.tangential / 0.05 - x - reference(where + ".impulse"), 1e-3, where);
            }
        }
}

// Without attraction the rebound is the same at any stiffness ratio.
TEST(ObliqueWall, does_not_depend_on_the_stiffness) {
    for (const double ratio : {1.0, 0.1, 0.01}) {
        ContactModel model = powder::model(ratio);
        model.rolling_friction = 0;
        const auto found = impact(model, powder::radius, 0.05, 1000).run(0.05);
        verify("tangential impulse over m v_n", found.tangential / 0.05 - 1 - reference("powder.damped.1.impulse"),
               3e-4, shortest(ratio));
    }
}

}  // namespace
}  // namespace recoat
