#include <cmath>

#include <gtest/gtest.h>

#include "analyzer/fields/height_map.hpp"
#include "analyzer/metrics/height.hpp"
#include "tests/analyzer/support.hpp"

namespace recoat {
namespace {

using testing::Ball;
using testing::fitted;
using testing::layer_of;
using testing::random_balls;
using testing::unit_config;

/// Highest point of the spheres over a square, found by trying the points of a fine mesh of it.
double sampled_height(const std::vector<Ball>& balls, double x, double y, Sides half, double width) {
    constexpr int points = 60;
    double height = 0;
    for (int i = 0; i <= points; ++i) {
        for (int j = 0; j <= points; ++j) {
            const double px = x + half.x * (2.0 * i / points - 1), py = y + half.y * (2.0 * j / points - 1);
            for (const Ball& ball : balls) {
                const double dx = px - ball.x, dy = std::remainder(py - ball.y, width);
                const double square = ball.radius * ball.radius - dx * dx - dy * dy;
                if (square > 0) height = std::max(height, ball.z + std::sqrt(square));
            }
        }
    }
    return height;
}

struct Case {
    double window, length = 5, width = 4;
};

class HeightMap : public ::testing::TestWithParam<Case> {};

TEST_P(HeightMap, IsTheHighestPointOverEverySquare) {
    const auto [window, length, width] = GetParam();
    AnalysisConfig config = unit_config(length, width);
    config.height_window = window;
    const std::vector<Ball> balls = random_balls(12, length, width, 3);
    const Map map = height_map(layer_of(balls, config), config);
    const Sides cell = {fitted(length, 1), fitted(width, 1)}, half = {window / 2 * cell.x, window / 2 * cell.y};
    for (int ix = 0; ix < map.nx; ++ix) {
        for (int iy = 0; iy < map.ny; ++iy) {
            const double sampled = sampled_height(balls, (ix + 0.5) * cell.x, (iy + 0.5) * cell.y, half, width);
            EXPECT_GE(map.at(ix, iy), sampled - 1e-12);
            // A sphere that reaches in by less than the mesh is seen lower, or not at all.
            if (sampled > 0) {
                EXPECT_LE(map.at(ix, iy), sampled + 0.2);
            }
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Windows, HeightMap,
                         ::testing::Values(Case{0.5}, Case{1}, Case{1.7}, Case{1, 5.4, 3.7}, Case{1.7, 4.6, 4.45}));

TEST(HeightMapValues, OneSphere) {
    const AnalysisConfig config = unit_config(4, 4);
    const Map map = height_map(layer_of({{1.2, 0.3, 0.5}}, config), config);
    EXPECT_DOUBLE_EQ(map.at(1, 0), 1);                             // its top is over the square
    EXPECT_DOUBLE_EQ(map.at(0, 0), 0.5 + std::sqrt(0.25 - 0.04));  // 0.2 from the square
    EXPECT_DOUBLE_EQ(map.at(1, 3), 0.5 + std::sqrt(0.25 - 0.09));  // through the period
    EXPECT_DOUBLE_EQ(map.at(0, 3), 0.5 + std::sqrt(0.25 - 0.13));  // over the corner
    EXPECT_EQ(map.at(2, 0), 0);
    EXPECT_EQ(map.at(1, 1), 0);
}

TEST(HeightMapValues, ATangentSphereHasNoHeight) {
    const AnalysisConfig config = unit_config(3, 3);
    const Map map = height_map(layer_of({{1.5, 1.5, 0.5}}, config), config);
    EXPECT_EQ(map.at(1, 1), 1);
    EXPECT_EQ(map.at(0, 1), 0);
    EXPECT_EQ(map.at(1, 2), 0);
}

Map map_of(std::vector<double> values) {
    Map map(0, 1, static_cast<int>(values.size()));
    map.values = std::move(values);
    return map;
}

TEST(HeightMetrics, BinsAreClosedAbove) {
    const HeightMetrics metrics = height_metrics(map_of({0, 0, 0.2, 0.25, 0.25 + 1e-9, 0.5, 0.51, 1.0}), 0.25, 1e-6);
    EXPECT_EQ(metrics.bin_upper_edges, (std::vector<double>{0.25, 0.5, 0.75, 1.0}));
    EXPECT_EQ(metrics.fraction, (std::vector<double>{3.0 / 8, 1.0 / 8, 1.0 / 8, 1.0 / 8}));
    EXPECT_EQ(metrics.empty_fraction, 0.25);
    EXPECT_EQ(metrics.max, 1);
}

TEST(HeightMetrics, RoughnessWithAndWithoutEmptyNodes) {
    const HeightMetrics metrics = height_metrics(map_of({0, 0, 1, 2}), 0.25, 1e-6);
    EXPECT_DOUBLE_EQ(metrics.mean, 0.75);
    EXPECT_DOUBLE_EQ(metrics.roughness, (0.75 + 0.75 + 0.25 + 1.25) / 4);
    EXPECT_DOUBLE_EQ(metrics.roughness_nonempty, 0.5);
}

TEST(HeightMetrics, AnEmptyLayerIsFlat) {
    const HeightMetrics metrics = height_metrics(map_of({0, 0, 0}), 0.25, 1e-6);
    EXPECT_EQ(metrics.empty_fraction, 1);
    EXPECT_EQ(metrics.roughness, 0);
    EXPECT_EQ(metrics.roughness_nonempty, 0);
    EXPECT_TRUE(metrics.bin_upper_edges.empty());
}

}  // namespace
}  // namespace recoat
