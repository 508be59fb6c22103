#include <cmath>
#include <string>

#include <gtest/gtest.h>

#include "tests/analytic/phases.hpp"
#include "tests/support/verification.hpp"

namespace recoat {
namespace {

using testing::over_phases;
using testing::pair_restitution;
using testing::verify;
namespace powder = testing::powder;

/// Errors of the restitution `e` over 32 phases.
testing::Errors errors_of(double e, double time_step) {
    ContactModel model = powder::model();
    model.restitution = e;
    return over_phases(32, [&](double phase) { return pair_restitution(model, time_step, 0.05, phase) - e; });
}

constexpr double duration = 4.471e-6;  ///< of an elastic impact of a pair at 0.05 m/s [docs/physics.md section 4.1]

struct Row {
    int steps;
    double mean, worst;
};

// Section 5.6: speed after undamped impacts, worst over the phases at 40, 80 and 160 steps per contact.
TEST(StepConvergence, of_undamped_impacts_is_that_of_the_table) {
    for (const Row& row : {Row{40, 0, 7.2e-5}, Row{80, 0, 1.3e-5}, Row{160, 0, 2.2e-6}}) {
        const auto errors = errors_of(1, duration / row.steps);
        verify("speed after " + std::to_string(row.steps) + " steps", errors.worst(), row.worst);
        EXPECT_GT(errors.worst(), 0.5 * row.worst) << "better than leapfrog can be: is there a contact?";
    }
}

// Section 4.3: the dashpot sees the velocity v + (dt/2) a_old. Its mean error is of second order: a repeated evaluation
// of all contact forces at the corrected velocity would make it 9e-5 at 40 steps, at twice the work, with the same
// worst.
TEST(StepConvergence, of_damped_impacts_is_of_second_order) {
    for (const Row& row : {Row{40, 1.3e-3, 4.5e-3}, Row{160, 9e-5, 6.5e-4}, Row{320, 2e-5, 4e-4}}) {
        const auto errors = errors_of(0.4, duration / row.steps);
        const std::string steps = std::to_string(row.steps) + " steps, absolute";
        verify("mean restitution at " + steps, errors.mean, row.mean);
        verify("worst restitution at " + steps, errors.worst(), row.worst);
    }
}

// Section 4.2: at 1e-7 s, 45 steps per contact.
TEST(StepConvergence, restitution_holds_at_five_times_the_step) {
    const auto errors = errors_of(0.4, 1e-7);
    verify("mean restitution, absolute", errors.mean, 1e-3);
    verify("worst restitution, absolute", errors.worst(), 4e-3);
}

TEST(StepConvergence, error_of_damped_impacts_falls_with_the_step) {
    double before = 1;
    for (const double time_step : {8e-8, 4e-8, 2e-8, 1e-8}) {
        const double worst = errors_of(0.4, time_step).worst();
        verify("worst error over that at twice the step", worst / before, 0.7);
        before = worst;
    }
}

}  // namespace
}  // namespace recoat
