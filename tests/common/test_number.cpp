#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "common/number.hpp"

namespace recoat {
namespace {

TEST(Number, EverySpellingOfOneThousandthIsTheSame) {
    for (const auto* text : {"1e-3", "1.e-3", "1.0e-3", ".001", "0.001", "1E-3", "+1e-3", "1e-03"}) {
        EXPECT_EQ(parse_number(text), 1e-3) << text;
    }
}

TEST(Number, AnythingElseIsRefused) {
    for (const auto* text : {"", " ", "1e", "e3", "1,5", "1 5", "0x10", "1.2.3", "--1", "+-1", "-", ".", "five"}) {
        EXPECT_FALSE(parse_number(text)) << text;
    }
}

TEST(Number, WholeNumbersHaveOnlyDigits) {
    EXPECT_EQ(parse_integer("42"), 42);
    EXPECT_EQ(parse_integer("-7"), -7);
    EXPECT_EQ(parse_integer("9223372036854775807"), std::numeric_limits<std::int64_t>::max());
    for (const auto* text : {"", "1.0", "1e3", "9223372036854775808", "4 2"}) EXPECT_FALSE(parse_integer(text)) << text;
}

TEST(Number, ShortestTextReadsBackAsTheSameDouble) {
    for (const double value : {0.1, 1.0 / 3, 5e-5, 1e300, 5e-324, -0.0, 110e9, 123456789.123456789}) {
        const auto again = parse_number(shortest(value));
        ASSERT_TRUE(again);
        EXPECT_EQ(*again, value);
        EXPECT_EQ(std::signbit(*again), std::signbit(value));
    }
    EXPECT_EQ(shortest(0.1), "0.1");
}

TEST(Number, TrimsBlanks) {
    EXPECT_EQ(trimmed(" \t a b \r\n"), "a b");
    EXPECT_EQ(trimmed("  "), "");
}

}  // namespace
}  // namespace recoat
