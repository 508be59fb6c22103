#include <numbers>
#include <random>

#include <gtest/gtest.h>

#include "analyzer/metrics/chamber_pores.hpp"
#include "analyzer/metrics/pixel_chambers.hpp"
#include "tests/analyzer/support.hpp"

namespace recoat {
namespace {

using testing::Ball;
using testing::layer_of;
using testing::unit_config;

/// Planes of a face-centred bed, each particle moved by up to `noise`, as the digits of a file do.
Layer face_centred(const AnalysisConfig& config, double noise) {
    std::mt19937_64 generator(3);
    const auto moved = [&](double value) {
        return value + noise * (2 * static_cast<double>(generator()) / 0x1p64 - 1);
    };
    std::vector<Ball> balls;
    for (int plane = 0; plane < 4; ++plane) {
        for (int i = -2; i < 12; ++i) {
            for (int j = 0; j < 8; ++j) {
                const double half = 0.5 * (plane % 2);
                balls.push_back({moved(i + half), moved(j + half), 0.5 + plane * std::numbers::sqrt2 / 2});
            }
        }
    }
    return layer_of(balls, config);
}

TEST(ChamberFloor, RoundOffMakesNoChambers) {
    AnalysisConfig config = unit_config(10, 8);
    config.chamber_min_diameter = 0;
    config.chamber_persistence = 0;
    for (const double noise : {0.0, 1e-15, 1e-13, 1e-9, 1e-5, 1e-4}) {
        const ChamberPoreMetrics metrics = chamber_pore_metrics(face_centred(config, noise), config);
        for (const ChamberPores* pores : {&metrics.all, &metrics.separate, &metrics.disjoint, &*metrics.persistent})
            EXPECT_EQ(pores->sizes.count, 0U) << noise;
        const PixelChambers pixels = pixel_chambers(face_centred(config, noise), config, 10);
        EXPECT_EQ(pixels.sizes.count, 0U) << noise;
    }
}

TEST(ChamberFloor, IsFarBelowTheHoleBetweenTouchingSpheres) {
    const AnalysisConfig config = unit_config(10, 20);
    for (const double radius : {0.5, 0.02}) {  // the smallest of a wide distribution too
        const Layer layer = layer_of({{4, 4, 0.5, radius},
                                      {4 + 2 * radius, 4, 0.5, radius},
                                      {4 + radius, 4 + std::numbers::sqrt3 * radius, 0.5, radius}},
                                     config);
        const ChamberPores pores = chamber_pore_metrics(layer, config).all;
        ASSERT_GE(pores.sizes.count, 1U);  // and what is between the three and their images along y
        EXPECT_NEAR(pores.sizes.sorted.front(), 2 * radius * (2 / std::numbers::sqrt3 - 1), 1e-9);
    }
}

}  // namespace
}  // namespace recoat
