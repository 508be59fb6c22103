#include <string>

#include <gtest/gtest.h>

#include "tests/analytic/approach.hpp"
#include "tests/support/verification.hpp"

namespace recoat {
namespace {

using testing::Approach;
using testing::Errors;
using testing::over_phases;
using testing::reference;
using testing::verify;
namespace powder = testing::powder;

class CohesiveRebound : public ::testing::TestWithParam<int> {};

// docs/physics.md section 2.6: rebound from 1.05, 1.5, 2 and 5 times the capture velocity, and from 0.05 m/s; the whole
// flight from the cut-off and back. Close to capture a small error of the contact is a large one of what is left.
TEST_P(CohesiveRebound, is_that_of_the_reference) {
    struct Case {
        std::string name;
        double mean, worst;
    };
    const Case cases[] = {
        {"1.05", 8e-3, 1.1e-2}, {"1.5", 1.4e-3, 2e-3}, {"2", 1.4e-3, 2e-3}, {"5", 1e-3, 2e-3}, {"fast", 1e-3, 2e-3}};
    for (const bool wall : {false, true}) {
        const Approach approach{powder::model(0.001, GetParam()), wall};
        const std::string which = approach.kind() + "." + std::to_string(GetParam());
        for (const Case& c : cases) {
            const double speed = c.name == "fast" ? 0.05 : std::stod(c.name) * reference("capture." + which);
            const double expected = reference("rebound." + which + "." + c.name);
            const Errors found = over_phases(testing::flights(16), [&](double phase) {
                return approach.rebound(speed, phase, approach.model.cut_off) / expected - 1;
            });
            const std::string from = c.name == "fast" ? "from 0.05 m/s" : "from " + c.name + " v_cap";
            verify(from + ", mean over the phases", found.mean, c.mean, which);
            verify(from + ", worst phase", found.worst(), c.worst, which);
        }
    }
}

INSTANTIATE_TEST_SUITE_P(BondNumber, CohesiveRebound, ::testing::Values(5, 50, 400),
                         [](const auto& bond) { return "bond_" + std::to_string(bond.param); });

// Section 2.6: release from rest at 0.3 nm.
TEST(Release, from_rest_within_the_range_falls_together) {
    const auto model = powder::model(0.001, 400);
    const auto engine = testing::head_on_pair(model, 2e-8, 3e-10, 0).engine();
    double separation = 3e-10, rate = 0;
    while (separation > 0) {
        engine->advance(1);
        separation = testing::pair_separation(engine->particles());
        rate = testing::pair_rate(engine->particles());
        ASSERT_LT(engine->step(), 100);
    }
    // Touch lies within the last step.
    testing::verify_relative("time to touch", engine->time() - separation / rate, reference("release.time"), 1e-3);
    testing::verify_relative("speed at touch", -rate, reference("release.speed"), 1e-3);
}

}  // namespace
}  // namespace recoat
