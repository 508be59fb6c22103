#include <gtest/gtest.h>

#include "solver/execution/launch_plan.hpp"

namespace recoat {
namespace {

TEST(LaunchPlan, MakesExactlyTheStepsWantedLargestFirst) {
    for (std::int64_t count = 0; count < 3000; ++count) {
        std::int64_t steps = 0, before = graph_sizes.front() + 1;
        for (const Launch& launch : plan_launches(count)) {
            EXPECT_LT(launch.steps, before);
            EXPECT_GT(launch.times, 0);
            before = launch.steps;
            steps += launch.steps * launch.times;
        }
        ASSERT_EQ(steps, count);
    }
}

TEST(LaunchPlan, NeedsFewLaunches) {
    EXPECT_TRUE(plan_launches(0).empty());
    EXPECT_EQ(plan_launches(1), (std::vector<Launch>{{1, 1}}));
    EXPECT_EQ(plan_launches(256), (std::vector<Launch>{{256, 1}}));
    EXPECT_EQ(plan_launches(1000), (std::vector<Launch>{{256, 3}, {32, 7}, {4, 2}}));
    for (std::int64_t count = 1; count < 256; ++count) {
        std::int64_t launches = 0;
        for (const Launch& launch : plan_launches(count)) launches += launch.times;
        EXPECT_LE(launches, 7 + 7 + 3);
    }
}

TEST(GrownCapacity, HasSlackAndGrowsInProportion) {
    for (const std::size_t n : {std::size_t{0}, std::size_t{1}, std::size_t{1000}, std::size_t{100'000'000}}) {
        EXPECT_GT(grown_capacity(n), n);
        EXPECT_LE(grown_capacity(n), n + n / 8 + 64);
    }
    // A list that grows entry by entry is moved a few dozen times, not thousands of times.
    std::size_t capacity = 0, moves = 0;
    for (std::size_t n = 1; n < 1'000'000; ++n) {
        if (n <= capacity) continue;
        capacity = grown_capacity(n);
        ++moves;
    }
    EXPECT_LT(moves, 90u);
}

TEST(BlockCount, CoversEveryThreadAndIsNeverZero) {
    EXPECT_EQ(block_count(0, 128), 1u);
    EXPECT_EQ(block_count(128, 128), 1u);
    EXPECT_EQ(block_count(129, 128), 2u);
    EXPECT_EQ(block_count(300'000'000, 128), 2343750u);
}

TEST(SignificantBits, AreEnoughForTheLargest) {
    EXPECT_EQ(significant_bits(0), 1);
    EXPECT_EQ(significant_bits(1), 1);
    EXPECT_EQ(significant_bits(2), 2);
    EXPECT_EQ(significant_bits(255), 8);
    EXPECT_EQ(significant_bits(256), 9);
    EXPECT_EQ(significant_bits(~std::uint64_t{0}), 64);
}

}  // namespace
}  // namespace recoat
