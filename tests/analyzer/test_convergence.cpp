#include <cmath>

#include <gtest/gtest.h>

#include "analyzer/convergence.hpp"
#include "analyzer/output/convergence_report.hpp"
#include "tests/analyzer/support.hpp"

namespace recoat {
namespace {

ConvergenceQuantity with_errors(double exact, const std::vector<double>& errors) {
    ConvergenceQuantity quantity;
    quantity.exact = exact;
    for (const double error : errors) quantity.voxel.push_back(exact + error);
    return quantity;
}

TEST(Convergence, FindsTheOrderOfAPowerLaw) {
    const std::vector<int> n = {4, 5, 10, 20};
    for (const double order : {0.5, 1.0, 2.0}) {
        std::vector<double> errors;
        double sign = 1;
        for (const int k : n) errors.push_back((sign = -sign) * 3 * std::pow(k, -order));
        ConvergenceQuantity quantity = with_errors(2, errors);
        judge(quantity, n, 1e-4, 2);
        ASSERT_TRUE(quantity.order);
        EXPECT_NEAR(*quantity.order, order, 1e-9);
        EXPECT_FALSE(quantity.enough);
        // 3 n^-p = 2e-4
        EXPECT_NEAR(*quantity.projected / std::pow(3 / 2e-4, 1 / order), 1, 1e-8);
    }
}

TEST(Convergence, EnoughIsWhereTheErrorStaysWithinTheTolerance) {
    const std::vector<int> n = {4, 8, 16, 32};
    ConvergenceQuantity quantity = with_errors(1, {0.005, -0.02, 0.01, 0.001});
    judge(quantity, n, 0.0100001, 1);
    EXPECT_EQ(*quantity.enough, 16);  // 4 is so by chance
    quantity = with_errors(1, {0.005, -0.02, 0.01, 0.03});
    judge(quantity, n, 0.01, 1);
    EXPECT_FALSE(quantity.enough);
    EXPECT_FALSE(quantity.projected);  // the error grows
    quantity = with_errors(0, {0, 0, 0, 0});
    judge(quantity, n, 0.01, 0);
    EXPECT_EQ(*quantity.enough, 4);
    EXPECT_FALSE(quantity.order);
}

TEST(Convergence, OfARandomLayer) {
    AnalysisConfig config = testing::unit_config(24, 8);
    config.voxels_per_dp = {4, 8, 16, 32};
    // Not touching: overlaps count once as voxels and twice in the exact form.
    auto balls = testing::random_balls(75, 0, 0, 3);
    for (std::size_t i = 0; i < balls.size(); ++i) {
        balls[i] = {1.6 * (i / 5) + 0.25 * balls[i].x / 2, 1.6 * (i % 5) + 0.25 * (balls[i].z - 1)};
    }
    const Analysis analysis = analyse(testing::layer_of(balls, config), config);
    const Convergence result = convergence(analysis, 0.02);
    EXPECT_EQ(result.voxels_per_dp, config.voxels_per_dp);
    const auto& rms = result.quantities[2];
    EXPECT_EQ(rms.name, "packing density, rms of nodes");
    EXPECT_EQ(rms.voxel[1], analysis.voxel[1].phi_error.rms);
    EXPECT_GT(*rms.order, 1.3);  // about 2
    EXPECT_LT(*rms.order, 2.7);
    const auto& height = result.quantities[3];
    EXPECT_EQ(height.exact, analysis.height.mean);
    EXPECT_GT(*height.order, 0.6);  // about 1
    EXPECT_LT(*height.order, 1.6);
    const auto& chambers = result.quantities[8];
    const auto& sizes = analysis.chamber_pores.persistent->sizes.sorted;
    EXPECT_EQ(chambers.exact, static_cast<double>(std::ranges::count_if(sizes, [](double d) { return d >= 0.5; })));
    const auto json = convergence_json(result);
    EXPECT_EQ(json["quantities"].size(), 12U);
    const PoreErrors& errors = *analysis.voxel[0].chamber_errors;
    EXPECT_EQ(chambers.voxel[0] - chambers.exact, result.quantities[10].voxel[0] - result.quantities[9].voxel[0]);
    EXPECT_EQ(result.quantities[9].voxel[0], static_cast<double>(errors.missed));
    EXPECT_EQ(json["quantities"][0]["error"][0].get<double>(),
              analysis.voxel[0].phi.median - analysis.phi_exact.median);
    EXPECT_NE(convergence_text(result).find("roughness Ra [d_p]"), std::string::npos);
}

TEST(Convergence, IsEnoughWhenItIsForEveryQuantity) {
    Convergence result;
    result.quantities.resize(2);
    result.quantities[0].enough = 8;
    EXPECT_FALSE(result.enough());
    result.quantities[1].enough = 20;
    EXPECT_EQ(*result.enough(), 20);
}

}  // namespace
}  // namespace recoat
