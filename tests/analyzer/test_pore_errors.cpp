#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "analyzer/metrics/pore_errors.hpp"

namespace recoat {
namespace {

TEST(ChamberErrors, PartnersAreTheNearestAcrossThePeriod) {
    const std::vector<Circle> exact = {{1, 0.1, 1}, {5, 5, 0.5}, {8, 5, 0.5}};
    // The first lies over y = 0; of the two near the second exact circle one is left over; the third has none.
    const std::vector<Circle> pixels = {{1, 9.9, 1.1}, {5.1, 5, 0.45}, {5.2, 5, 0.5}, {8, 5.31, 0.5}};
    const PoreErrors errors = chamber_errors(exact, pixels, 10, 0.3);
    EXPECT_EQ(errors.matched, 2U);
    EXPECT_EQ(errors.missed, 1U);
    EXPECT_EQ(errors.spurious, 2U);
    ASSERT_TRUE(errors.size);
    EXPECT_NEAR(errors.size->bias, (0.2 - 0.1) / 2, 1e-12);
    EXPECT_NEAR(errors.size->deviation, 0.15, 1e-12);
}

TEST(ChamberErrors, NoneOnOneSide) {
    EXPECT_EQ(chamber_errors({{1, 1, 1}}, {}, 10, 0.3).missed, 1U);
    EXPECT_EQ(chamber_errors({}, {{1, 1, 1}}, 10, 0.3).spurious, 1U);
    EXPECT_FALSE(chamber_errors({}, {}, 10, 0.3).size);
}

TEST(DensityPoreErrors, PartnersShareTheMostCells) {
    // Rows are x. The exact map has a pore of 4 cells, one of 1 and one of 1; in voxels the first has fallen in two.
    Map exact(0, 3, 9), voxels(0, 3, 9);
    for (Map* map : {&exact, &voxels}) map->values.assign(27, 1.0);
    for (const int j : {0, 1, 2, 3, 5, 7}) exact.at(1, j) = 0;
    for (const int j : {0, 2, 3, 5}) voxels.at(1, j) = 0;
    const PoreErrors errors = density_pore_errors(exact, voxels, 0.5, 4);
    EXPECT_EQ(errors.matched, 2U);
    EXPECT_EQ(errors.missed, 1U);
    EXPECT_EQ(errors.spurious, 1U);
    const auto diameter = [](double cells) { return 2 * std::sqrt(4 * cells / std::numbers::pi); };
    ASSERT_TRUE(errors.size);
    EXPECT_NEAR(errors.size->bias, (diameter(2) - diameter(4)) / 2, 1e-12);
}

}  // namespace
}  // namespace recoat
