#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "analyzer/metrics/totals.hpp"
#include "analyzer/metrics/vertical.hpp"
#include "tests/analyzer/support.hpp"

namespace recoat {
namespace {

using testing::Ball;
using testing::layer_of;
using testing::unit_config;

TEST(Totals, FaceCentredCubicBedOfSixteenPlanes) {
    std::vector<Ball> balls;
    const double rise = std::sqrt(0.5);
    for (int k = 0; k < 16; ++k) {
        for (int i = -2; i < 8; ++i) {
            for (int j = 0; j < 4; ++j) balls.push_back({i + 0.5 * (k % 2), j + 0.5 * (k % 2), 0.5 + rise * k});
        }
    }
    const AnalysisConfig config = unit_config(6, 4);
    const TotalsMetrics totals = totals_metrics(layer_of(balls, config), config);
    ASSERT_TRUE(totals.bed);
    // Planes of one sphere per d_p^2 up to 0.9 of the top; the 15th is cut 0.03945 above its centre, the 16th below.
    const double top = 0.9 * (1 + 15 * rise), sphere = std::numbers::pi / 6;
    const auto below = [&](int plane) {
        const double height = std::clamp(top - rise * plane, 0.0, 1.0);
        return std::numbers::pi * height * height * (1.5 - height) / 3;
    };
    double clipped = 0;
    for (int k = 0; k < 16; ++k) clipped += below(k);
    EXPECT_NEAR(totals.bed->clipped, clipped / top, 1e-12);
    EXPECT_NEAR(totals.bed->centre, 15 * sphere / top, 1e-12);
    EXPECT_NEAR(totals.bed->all, 16 * sphere / top, 1e-12);
    EXPECT_NEAR(totals.bed->clipped, 0.7303, 5e-5);
    EXPECT_NEAR(totals.bed->centre, 0.7519, 5e-5);
    EXPECT_NEAR(totals.bed->all, 0.8020, 5e-5);
}

TEST(Totals, ClipsAtTheEndsOfTheRegion) {
    AnalysisConfig config = unit_config(4, 4);
    config.density = 10;
    // One whole sphere inside, one halved by the start (its centre inside), one halved by the end (its centre outside).
    const Layer layer = layer_of({{2, 2}, {0, 1}, {4, 3}}, config);
    const TotalsMetrics totals = totals_metrics(layer, config);
    const double sphere = std::numbers::pi / 6;
    EXPECT_NEAR(totals.volume_whole, 2 * sphere, 1e-14);
    EXPECT_NEAR(totals.volume_clipped, 2 * sphere, 1e-14);
    EXPECT_DOUBLE_EQ(totals.area, 16);
    EXPECT_NEAR(totals.mass_per_area, 20 * sphere / 16, 1e-14);
    EXPECT_NEAR(totals.layer_phi, 2 * sphere / (16 * 1.5), 1e-14);
}

TEST(Totals, ScaleWithTheParticleDiameter) {
    AnalysisConfig config = unit_config(4e-3, 4e-3);
    config.particle_diameter = 1e-3;
    config.clearance = 1.5e-3;
    const TotalsMetrics totals = totals_metrics(layer_of({{2e-3, 2e-3, 0.5e-3, 0.5e-3}}, config), config);
    EXPECT_NEAR(totals.volume_whole / 1e-9, std::numbers::pi / 6, 1e-12);
    EXPECT_NEAR(totals.area / 1e-6, 16, 1e-12);
    EXPECT_NEAR(totals.layer_phi, std::numbers::pi / 6 / 24, 1e-14);
}

TEST(Totals, OfNothingHaveNoBed) {
    const AnalysisConfig config = unit_config(4, 4);
    const TotalsMetrics totals = totals_metrics(layer_of({{9, 1}}, config), config);
    EXPECT_FALSE(totals.bed);
    EXPECT_EQ(totals.volume_whole, 0);
}

TEST(Vertical, BinsAreCentredOnMultiples) {
    const AnalysisConfig config = unit_config(4, 4);
    const Layer layer = layer_of({{1, 1, 0.5}, {2, 1, 0.4999}, {1, 2, 0.55}, {2, 2, 1.05 - 1e-9}, {9, 9, 3}}, config);
    const VerticalMetrics metrics = vertical_metrics(layer, 0.1, 1e-6);
    ASSERT_EQ(metrics.fraction.size(), 12U);  // the highest of the region lies on the edge between 1.0 and 1.1
    EXPECT_EQ(metrics.fraction[5], 0.5);
    EXPECT_EQ(metrics.fraction[6], 0.25);
    EXPECT_EQ(metrics.fraction[11], 0.25);
    ASSERT_TRUE(metrics.summary);
    EXPECT_EQ(metrics.summary->fraction_above_1dp, 0.25);
    EXPECT_EQ(metrics.summary->fraction_touching_base, 0.5);
    EXPECT_DOUBLE_EQ(metrics.summary->max, 1.05 - 1e-9);
}

TEST(Vertical, OfNothingHasNoSummary) {
    const AnalysisConfig config = unit_config(4, 4);
    EXPECT_FALSE(vertical_metrics(layer_of({}, config), 0.1, 1e-6).summary);
}

}  // namespace
}  // namespace recoat
