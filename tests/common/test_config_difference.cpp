#include <gtest/gtest.h>

#include "common/config_difference.hpp"

namespace recoat {
namespace {

TEST(ConfigDifference, NamesKeysAndBothValues) {
    const auto found = config_differences("a: 1\nb: {c: 2 um, d: [1, 2]}\nstages:\n  - fill: {t: 1 s}\n",
                                          "a: 1\nb: {c: 3 um, d: [1, 2, 4]}\nstages:\n  - fill: {t: 2 s}\nseed: 7\n");
    ASSERT_EQ(found.size(), 4U);
    EXPECT_EQ(found[0].key, "b.c");
    EXPECT_EQ(found[0].first, "2 um");
    EXPECT_EQ(found[0].second, "3 um");
    EXPECT_EQ(found[1].key, "stages.0.fill.t");
    EXPECT_EQ(found[2].key, "b.d.2");
    EXPECT_EQ(found[2].first, "");
    EXPECT_EQ(found[3].key, "seed");
    EXPECT_EQ(found[3].second, "7");
}

TEST(ConfigDifference, IsEmptyForTheSame) { EXPECT_TRUE(config_differences("a: 1\n# a comment\n", "a: 1\n").empty()); }

}  // namespace
}  // namespace recoat
