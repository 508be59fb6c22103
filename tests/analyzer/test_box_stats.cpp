#include <gtest/gtest.h>

#include "analyzer/metrics/box_stats.hpp"

namespace recoat {
namespace {

TEST(Quantile, IsLinearBetweenOrderStatistics) {
    const std::vector<double> four = {1, 2, 3, 4};
    EXPECT_DOUBLE_EQ(quantile(four, 0.25), 1.75);
    EXPECT_DOUBLE_EQ(quantile(four, 0.5), 2.5);
    EXPECT_DOUBLE_EQ(quantile(four, 0), 1);
    EXPECT_DOUBLE_EQ(quantile(four, 1), 4);
    const std::vector<double> five = {1, 2, 4, 8, 16};
    EXPECT_DOUBLE_EQ(quantile(five, 0.25), 2);
    EXPECT_DOUBLE_EQ(quantile(five, 0.9), 12.8);
    EXPECT_DOUBLE_EQ(quantile(std::vector<double>{7}, 0.3), 7);
}

TEST(BoxStats, WhiskersEndAtDataWithinTheFences) {
    // Quartiles 3.25 and 7.75, fences -3.5 and 14.5.
    const BoxStats stats = box_stats(std::vector<double>{10, 9, 8, 7, 6, 5, 4, 3, 1, 100, -3.6, 2});
    const std::vector<double> sorted = {-3.6, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 100};
    EXPECT_DOUBLE_EQ(stats.q1, 2.75);
    EXPECT_DOUBLE_EQ(stats.q3, 8.25);
    EXPECT_DOUBLE_EQ(stats.iqr, 5.5);
    EXPECT_DOUBLE_EQ(stats.median, 5.5);
    EXPECT_EQ(stats.whisker_lo, -3.6);  // the lower fence is -5.5
    EXPECT_EQ(stats.whisker_hi, 10);
    EXPECT_EQ(stats.n_outliers, 1U);
    EXPECT_EQ(stats.max, 100);
    EXPECT_DOUBLE_EQ(stats.iqr_over_median.value(), 1);
    EXPECT_EQ(stats.n, sorted.size());
}

TEST(BoxStats, OnTheFenceIsNoOutlier) {
    // Quartiles 1 and 2: fences -0.5 and 3.5.
    const BoxStats stats = box_stats(std::vector<double>{-0.5, 1, 1, 1.5, 2, 2, 3.5});
    EXPECT_EQ(stats.q1, 1);
    EXPECT_EQ(stats.q3, 2);
    EXPECT_EQ(stats.n_outliers, 0U);
    EXPECT_EQ(stats.whisker_hi, 3.5);
}

TEST(BoxStats, RoundOffMakesNoOutliers) {
    std::vector<double> values(100, 0.35);
    values[7] = 0.35 + 1e-16;
    values[8] = 0.35 - 1e-16;
    EXPECT_EQ(box_stats(values).n_outliers, 0U);
    values[9] = 0.35 + 1e-9;
    EXPECT_EQ(box_stats(values).n_outliers, 1U);
}

TEST(BoxStats, NoRatioToAMedianOfZero) {
    const BoxStats stats = box_stats(std::vector<double>{0, 0, 0, 1});
    EXPECT_FALSE(stats.iqr_over_median);
    EXPECT_EQ(stats.mean, 0.25);
    EXPECT_EQ(stats.n_outliers, 1U);  // quartiles 0 and 0.25
}

TEST(BoxStats, OfNothingAreZero) {
    const BoxStats stats = box_stats({});
    EXPECT_EQ(stats.n, 0U);
    EXPECT_EQ(stats.max, 0);
    EXPECT_FALSE(stats.iqr_over_median);
}

}  // namespace
}  // namespace recoat
