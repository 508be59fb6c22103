#include <string>

#include <gtest/gtest.h>

#include "tests/analytic/approach.hpp"
#include "tests/support/verification.hpp"

namespace recoat {
namespace {

using testing::Approach;
using testing::capture_errors;
using testing::Errors;
using testing::verify;
namespace powder = testing::powder;

/// The numbers of docs/physics.md section 2.6's design for a Bond number, at r = 0.001 and 2e-8 s: mean error where the
/// reduced Hamaker constant acts out of contact too, and the spread of the other schemes over the phases.
struct Row {
    int bond;
    double reduced, explicit_spread, correction_spread;
};

class CaptureSchemes : public ::testing::TestWithParam<Row> {
protected:
    static Approach approach(CohesionScheme scheme) {
        Approach result{powder::model(0.001, GetParam().bond)};
        result.model.scheme = scheme;
        return result;
    }
};

TEST_P(CaptureSchemes, explicit_force_is_right_on_average) {
    const Errors found = capture_errors(approach(CohesionScheme::explicit_force), GetParam().bond, 32, 0.03);
    verify("mean over the phases", found.mean, 2e-3);
    verify("worst phase", found.worst(), 1.4 * GetParam().explicit_spread);
}

TEST_P(CaptureSchemes, prediction_correction_is_right_on_average) {
    const Errors found = capture_errors(approach(CohesionScheme::prediction_correction), GetParam().bond, 32, 0.03);
    verify("mean over the phases", found.mean, 4e-3);
    verify("worst phase", found.worst(), 1.4 * GetParam().correction_spread);
}

// Common practice, and wrong by a third and more.
TEST_P(CaptureSchemes, reduced_attraction_out_of_contact_is_wrong_by_what_is_known) {
    Approach reduced = approach(CohesionScheme::explicit_force);
    reduced.model.non_contact = NonContactHamaker::reduced;
    const Errors found = capture_errors(reduced, GetParam().bond, 8, 0.1, 1 + GetParam().reduced);
    verify("error less the known one, absolute", found.mean - GetParam().reduced, 0.01);
}

INSTANTIATE_TEST_SUITE_P(BondNumber, CaptureSchemes,
                         ::testing::Values(Row{5, -0.64, 0.0034, 0.0031}, Row{50, -0.50, 0.0095, 0.0059},
                                           Row{400, -0.31, 0.013, 0.016}),
                         [](const auto& row) { return "bond_" + std::to_string(row.param.bond); });

}  // namespace
}  // namespace recoat
