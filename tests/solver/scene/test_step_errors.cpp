#include <cmath>
#include <fstream>
#include <string>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "common/number.hpp"
#include "solver/scene/step_errors.hpp"
#include "tests/support/scene_text.hpp"

namespace recoat {
namespace {

using testing::scene_of;
using testing::spread_text;

nlohmann::json accuracy() { return nlohmann::json::parse(std::ifstream(RECOAT_ACCURACY)); }

/// What is said of a step of the paper's powder.
std::optional<StepErrors> said(double bond, double ratio, double step) {
    return step_errors(
        scene_of(spread_text, {"cohesion.bond_number=" + shortest(bond), "stiffness_ratio=" + shortest(ratio),
                               "time_step=" + shortest(step) + " s"}));
}

double worst(const nlohmann::json& errors, const std::string& quantity) {
    double largest = 0;
    for (const char* kind : {"pair", "wall"})
        largest = std::max(largest, std::fabs(errors.at(quantity + ", " + kind).at("worst").get<double>()));
    return largest;
}

// docs/accuracy.md: nothing that was measured is worse than what is said, at any ratio.
TEST(StepErrors, are_those_of_two_bodies) {
    int steps = 0;
    const nlohmann::json cases = accuracy().at("two_body");
    for (const auto& one : cases) {
        if (one.at("scheme") != "discrete_gradient" || one.at("ratio") > 0.5) continue;
        const double bond = one.at("bond"), ratio = one.at("ratio");
        for (const auto& row : one.at("steps")) {
            const double step = row.at("time_step");
            const std::optional<StepErrors> found = said(bond, ratio, step);
            if (!found) break;
            ++steps;
            const auto& errors = row.at("errors");
            EXPECT_LE(worst(errors, "capture velocity"), found->capture_velocity)
                << bond << ' ' << ratio << ' ' << step;
            EXPECT_LE(worst(errors, "rebound from 0.05 m/s"), found->rebound) << bond << ' ' << ratio << ' ' << step;
        }
    }
    EXPECT_GT(steps, 100);
}

TEST(StepErrors, are_those_of_beds_and_layers) {
    int rows = 0;
    const nlohmann::json powder = accuracy().at("recommended").at("powder");
    for (const auto& row : powder)
        for (const auto& step : row.at("steps")) {
            const std::optional<StepErrors> found = said(row.at("bond"), 0.001, step.at("time_step"));
            if (!found) continue;
            ++rows;
            EXPECT_LE(step.at("energy_balance_error").get<double>(), found->energy_balance) << row.at("bond") << step;
        }
    EXPECT_GT(rows, 16);
}

TEST(StepErrors, are_unknown_beyond_what_was_measured) {
    EXPECT_TRUE(said(5, 0.001, 1e-7));
    EXPECT_FALSE(said(5, 0.001, 4e-7));
    EXPECT_FALSE(said(4000, 0.0001, 1e-7));
}

}  // namespace
}  // namespace recoat
