#include <limits>

#include <gtest/gtest.h>

#include "common/readable.hpp"

namespace recoat {
namespace {

TEST(Readable, TakesThePrefixThatKeepsNumbersShort) {
    EXPECT_EQ(readable(5e-5, "m"), "50 um");
    EXPECT_EQ(readable(1, "m"), "1 m");
    EXPECT_EQ(readable(-2.5e-3, "s"), "-2.5 ms");
    EXPECT_EQ(readable(6.04395604e10, "Pa"), "60.44 GPa");
    EXPECT_EQ(readable(2.899428e-10, "kg"), "289.9 ng");
    EXPECT_EQ(readable(1.4221695e-7, "N"), "142.2 nN");
    EXPECT_EQ(readable(0, "m"), "0 m");
    EXPECT_EQ(readable_speed(0.05), "50 mm/s");
}

TEST(Readable, RoundsIntoTheNextPrefix) {
    EXPECT_EQ(readable(999.96e-9, "s"), "1 us");
    EXPECT_EQ(readable(999.6e-9, "s"), "999.6 ns");
}

TEST(Readable, KeepsTheExponentWhereNoPrefixFits) {
    EXPECT_EQ(readable(1.858e-21, "J"), "1.858e-21 J");
    EXPECT_EQ(readable(7.25e-20, "kg m2"), "7.25e-20 kg m2");
    EXPECT_EQ(readable(0.001, ""), "0.001");
    EXPECT_EQ(readable(0.1666, "d_p"), "0.1666 d_p");
}

TEST(Readable, TimesInTheUnitOfAPerson) {
    EXPECT_EQ(readable_duration(6.1e-8 * 3600), "0.22 ms");
    EXPECT_EQ(readable_duration(2.2e-6), "2.2 us");
    EXPECT_EQ(readable_duration(0.34), "0.34 s");
    EXPECT_EQ(readable_duration(12), "12 s");
    EXPECT_EQ(readable_duration(109), "109 s");
    EXPECT_EQ(readable_duration(150), "2.5 min");
    EXPECT_EQ(readable_duration(389 * 3600.0), "16 days");
    EXPECT_EQ(readable_duration(3e9), "95 years");
    EXPECT_EQ(readable_duration(0), "0 s");
    EXPECT_EQ(readable_duration(std::numeric_limits<double>::infinity()), "for ever");
}

// However long: never an exponent, never an empty text.
TEST(Readable, EveryTimeHasAText) {
    for (double seconds = 1e-9; seconds < 3e10; seconds *= 1.07) {
        const std::string text = readable_duration(seconds);
        EXPECT_EQ(text.find('e', 0) != std::string::npos && text.find("e+") != std::string::npos, false) << text;
        EXPECT_GE(text.size(), 3U) << seconds;
        EXPECT_LE(text.size(), 10U) << text;
    }
}

TEST(Readable, SizesInPowersOf1024) {
    EXPECT_EQ(readable_bytes(812), "812 bytes");
    EXPECT_EQ(readable_bytes(1.4 * 1048576), "1.4 MiB");
    EXPECT_EQ(readable_bytes(1023 * 1024.0), "1023 KiB");
    EXPECT_EQ(readable_bytes(0), "0 bytes");
}

TEST(Readable, CountsWithTheirThousandsApart) {
    EXPECT_EQ(readable_count(200), "200");
    EXPECT_EQ(readable_count(25075000), "25 075 000");
    EXPECT_EQ(readable_count(-1000), "-1 000");
}

}  // namespace
}  // namespace recoat
