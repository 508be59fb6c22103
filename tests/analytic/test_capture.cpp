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

/// Mean and worst of the relative errors over the phases of a step.
struct Allowed {
    double mean, worst;
};

/// The same by Bond number; 1 and 200, which the table leaves out, as 5 and 400.
struct Row {
    Allowed bond_5, bond_50, bond_400;
    [[nodiscard]] Allowed at(int bond) const { return bond <= 5 ? bond_5 : bond == 50 ? bond_50 : bond_400; }
};

class Capture : public ::testing::TestWithParam<int> {
protected:
    /// Of a pair and of a wall, looked for within `width`.
    static void verify_errors(double ratio, double time_step, double width, const Row& row) {
        const bool tabulated = GetParam() != 1 && GetParam() != 200;
        const int phases = tabulated && ratio == 0.001 && time_step == 2e-8 ? 32 : tabulated ? 16 : 8;
        for (const bool wall : {false, true}) {
            const Approach approach{powder::model(ratio, GetParam()), wall, time_step};
            const Errors found = capture_errors(approach, GetParam(), phases, width);
            verify(approach.kind() + ", mean over the phases of a step", found.mean, row.at(GetParam()).mean);
            verify(approach.kind() + ", worst phase", found.worst(), row.at(GetParam()).worst);
        }
    }
};

// docs/physics.md section 2.6: capture velocities at the step of the paper.
TEST_P(Capture, velocity_at_the_step_of_the_paper) {
    verify_errors(0.001, 2e-8, 0.01, {{8e-4, 9e-4}, {8e-4, 1.3e-3}, {1e-3, 1.2e-3}});
}

// Stiffer contacts are short of steps: the error of the phase comes from the dashpot.
TEST_P(Capture, velocity_at_ten_times_the_stiffness) {
    verify_errors(0.01, 2e-8, 0.02, {{1.6e-3, 2.5e-3}, {2.3e-3, 2.5e-3}, {2.8e-3, 2.5e-3}});
}

TEST_P(Capture, velocity_at_a_hundred_times_the_stiffness) {
    verify_errors(0.1, 2e-8, 0.03, {{4.5e-3, 1e-2}, {5.7e-3, 1e-2}, {6.6e-3, 1e-2}});
}

TEST_P(Capture, velocity_at_two_and_a_half_times_the_step) {
    verify_errors(0.001, 5e-8, 0.02, {{1.7e-3, 3.8e-3}, {2.3e-3, 3.8e-3}, {2.5e-3, 3.8e-3}});
}

TEST_P(Capture, velocity_at_five_times_the_step) {
    verify_errors(0.001, 1e-7, 0.03, {{3.7e-3, 6.9e-3}, {4.5e-3, 6.9e-3}, {4.8e-3, 6.9e-3}});
}

TEST_P(Capture, velocity_at_ten_times_the_step) {
    verify_errors(0.001, 2e-7, 0.05, {{7.6e-3, 1.5e-2}, {9e-3, 1.5e-2}, {1.01e-2, 1.5e-2}});
}

INSTANTIATE_TEST_SUITE_P(BondNumber, Capture, ::testing::Values(1, 5, 50, 200, 400),
                         [](const auto& bond) { return "bond_" + std::to_string(bond.param); });

}  // namespace
}  // namespace recoat
