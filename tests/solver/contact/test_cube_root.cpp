#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "solver/contact/cube_root.hpp"

namespace recoat {
namespace {

TEST(CubeRoot, AgreesWithTheLibraryOverTheWholeRange) {
    std::mt19937_64 random(1);
    std::uniform_real_distribution<double> exponent(-289.9, 307.5);
    double worst = 0;
    for (int k = 0; k < 200000; ++k) {
        const double x = std::pow(10.0, exponent(random));
        worst = std::max(worst, std::fabs(cube_root(x) / std::cbrt(x) - 1));
    }
    EXPECT_LT(worst, 1e-11);
}

// The guess repeats with every factor of 8; within it, its error is greatest at a few points.
TEST(CubeRoot, AgreesWithTheLibraryWithinAnOctave) {
    double worst = 0;
    for (int k = 0; k < 100000; ++k) {
        const double x = std::exp2(3.0 * k / 100000.0);
        worst = std::max(worst, std::fabs(cube_root(x) / std::cbrt(x) - 1));
    }
    EXPECT_LT(worst, 1e-11);
}

TEST(CubeRoot, IsZeroAtZeroAndBelowItsRange) {
    EXPECT_EQ(cube_root(0), 0);
    EXPECT_EQ(cube_root(1e-300), 0);
    EXPECT_EQ(cube_root(-1), 0);
    EXPECT_NEAR(cube_root(2e-290) / std::cbrt(2e-290), 1, 1e-11);
}

}  // namespace
}  // namespace recoat
