#include <cmath>
#include <numeric>
#include <random>

#include <gtest/gtest.h>

#include "solver/execution/openmp.hpp"
#include "solver/execution/value.hpp"

namespace recoat {
namespace {

std::vector<double> random_numbers(std::size_t n) {
    std::mt19937_64 random(n);
    std::normal_distribution<double> normal;
    std::vector<double> values(n);
    for (double& value : values) value = normal(random) * std::exp(20 * normal(random));
    return values;
}

const std::size_t sizes[] = {0, 1, 31, 32, 33, 1023, 1024, 1025, 5000, 1'200'000};

TEST(OpenMP, SumsToRoundingAndInOneOrder) {
    for (const std::size_t n : sizes) {
        const std::vector<double> values = random_numbers(n);
        const auto at = [&](std::size_t k) { return values[k]; };
        long double exact = 0, absolute = 0;
        for (const double value : values) {
            exact += value;
            absolute += std::fabs(value);
        }
        const double sum = OpenMP(1).sum(n, at);
        EXPECT_NEAR(sum, static_cast<double>(exact), 1e-15 * static_cast<double>(absolute)) << n;
        EXPECT_EQ(sum, OpenMP(3).sum(n, at)) << n;
    }
}

// The order, once more by hand: lanes of a stride of 32 within blocks of 1024, halved, and then the same over blocks.
TEST(OrderedSum, IsTheOrderThatItSays) {
    const std::size_t n = 3000;
    const std::vector<double> values = random_numbers(n);
    std::vector<double> blocks;
    for (std::size_t b = 0; b < 3; ++b) {
        double lane[32] = {};
        for (std::size_t k = b * 1024; k < std::min<std::size_t>(n, (b + 1) * 1024); ++k) lane[k % 32] += values[k];
        for (const std::size_t half : {16, 8, 4, 2, 1})
            for (std::size_t l = 0; l < half; ++l) lane[l] += lane[l + half];
        blocks.push_back(lane[0]);
    }
    EXPECT_EQ(OpenMP(1).sum(n, [&](std::size_t k) { return values[k]; }), (blocks[0] + blocks[2]) + blocks[1]);
}

TEST(OpenMP, MaximumIsTheLargestOrNone) {
    for (const std::size_t n : sizes) {
        std::vector<double> values = random_numbers(n);
        for (double& value : values) value = -std::fabs(value);
        const double expected =
            n == 0 ? -std::numeric_limits<double>::infinity() : *std::max_element(values.begin(), values.end());
        EXPECT_EQ(OpenMP(2).maximum(n, [&](std::size_t k) { return values[k]; }), expected);
    }
}

TEST(OpenMP, ScanIsTheSumOfThoseBefore) {
    std::vector<std::int32_t> counts = {3, 0, 4, 1, 0};
    OpenMP::exclusive_scan(counts);
    EXPECT_EQ(counts, (std::vector<std::int32_t>{0, 3, 3, 7, 8}));
    EXPECT_EQ(OpenMP::picked(counts, 1, 2, 2), (std::vector<std::int32_t>{3, 7}));
}

TEST(OpenMP, SortedOrderSorts) {
    std::vector<std::uint64_t> keys(1000);
    std::iota(keys.begin(), keys.end(), std::uint64_t{1} << 40);
    std::shuffle(keys.begin(), keys.end(), std::mt19937_64(1));
    std::vector<std::int32_t> order;
    OpenMP::sorted_order(keys, std::uint64_t{1} << 41, order);
    for (std::size_t k = 0; k < keys.size(); ++k)
        ASSERT_EQ(keys[static_cast<std::size_t>(order[k])], (std::uint64_t{1} << 40) + k);
}

TEST(OpenMP, GroupsKeepTheOrderAndLeaveOut) {
    const std::vector<std::int32_t> bucket = {2, 0, 3, 2, 3, 0, 2};
    std::vector<std::int32_t> begin, entries;
    OpenMP::group(
        bucket.size(), 3, [&](std::size_t e) { return bucket[e]; }, begin, entries);
    EXPECT_EQ(begin, (std::vector<std::int32_t>{0, 2, 2, 5}));
    EXPECT_EQ(entries, (std::vector<std::int32_t>{1, 5, 0, 3, 6}));
    OpenMP::group(
        0, 2, [&](std::size_t) { return 0; }, begin, entries);
    EXPECT_EQ(begin, (std::vector<std::int32_t>{0, 0, 0}));
    EXPECT_TRUE(entries.empty());
}

struct Countdown {
    int* left;
    bool running() const { return *left > 0; }
    void operator()() const { --*left; }
};

TEST(OpenMP, RepeatsUntilToldToStop) {
    int left = 5, done = 0;
    const Countdown end{&left};
    OpenMP::repeat(3, end, [&] { ++done, end(); });
    EXPECT_EQ(done, 3);
    OpenMP::repeat(10, end, [&] { ++done, end(); });
    EXPECT_EQ(done, 5);
}

TEST(Value, IsWhatWasAssignedLast) {
    OpenMP space(1);
    Value<OpenMP, double> value;
    value.assign(space, 3);
    double* place = value.data();
    value.assign(space, 4);
    EXPECT_EQ(value.data(), place) << "loops keep the address";
    EXPECT_EQ(value.read(space), 4);
}

}  // namespace
}  // namespace recoat
