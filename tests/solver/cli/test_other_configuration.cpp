#include <gtest/gtest.h>

#include "solver/other_configuration.hpp"

namespace recoat {
namespace {

TEST(OtherConfiguration, NamesTheKeysThatDifferWithBothValues) {
    EXPECT_EQ(configuration_differences("seed: 1\nblade: {speed: 50 mm/s}\n", "seed: 1\nblade: {speed: 60 mm/s}\n"),
              "blade.speed is 50 mm/s there and 60 mm/s here");
    EXPECT_EQ(configuration_differences("seed: 1\n", "seed: 1\nstart: 2\n"), "start is absent there and 2 here");
    EXPECT_EQ(
        configuration_differences("a: 1\nb: 1\nc: 1\nd: 1\ne: 1\nf: 1\n", "a: 2\nb: 2\nc: 2\nd: 2\ne: 2\nf: 2\n"),
        "a is 1 there and 2 here; b is 1 there and 2 here; c is 1 there and 2 here; d is 1 there and 2 here; and 2 "
        "more");
}

TEST(OtherConfiguration, OtherContentOfATableIsSaid) {
    EXPECT_EQ(configuration_differences("a: 1\n# content of table.csv: 01\n", "a: 1\n# content of table.csv: 02\n"),
              "the file that the particles come from has other content");
    EXPECT_EQ(configuration_differences("a: 1\n", "a: 1\n"), "");
}

}  // namespace
}  // namespace recoat
