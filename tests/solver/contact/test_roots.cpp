#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "solver/contact/roots.hpp"

namespace recoat {
namespace {

/// Largest relative errors of the roots over `decades` to either side of 1, against long double.
template <class Real>
struct Errors {
    double root = 0, fourth = 0, sixth = 0;

    explicit Errors(double decades) {
        std::mt19937_64 random(3);
        std::uniform_real_distribution<double> exponent(-decades, decades);
        for (int k = 0; k < 200000; ++k) {
            const auto x = static_cast<Real>(std::pow(10, exponent(random)));
            const long double exact = x;
            root = std::max(root, static_cast<double>(std::fabs(inverse_root(x) * std::sqrt(exact) - 1)));
            fourth = std::max(fourth,
                              static_cast<double>(std::fabs(inverse_fourth_root(x) * std::sqrt(std::sqrt(exact)) - 1)));
            sixth =
                std::max(sixth, static_cast<double>(std::fabs(inverse_sixth_root(x) * std::pow(exact, 1.0L / 6) - 1)));
        }
    }
};

TEST(Roots, DoubleIsExactToTwoUnitsInTheLastPlace) {
    const Errors<double> errors(290);
    EXPECT_LT(errors.root, 4.5e-16);
    EXPECT_LT(errors.fourth, 4.5e-16);
    EXPECT_LT(errors.sixth, 4.5e-16);
}

TEST(Roots, SingleIsExactToTwoUnitsInTheLastPlace) {
    const Errors<float> errors(36);
    EXPECT_LT(errors.root, 2.4e-7);
    EXPECT_LT(errors.fourth, 2.4e-7);
    EXPECT_LT(errors.sixth, 2.4e-7);
}

// So that x times them is the root of nothing, without a case of its own.
TEST(Roots, OfNothingAreFinite) {
    EXPECT_EQ(0.0 * inverse_root(0.0), 0);
    EXPECT_EQ(0.0f * inverse_root(0.0f), 0);
    EXPECT_EQ(0.0 * std::pow(inverse_fourth_root(0.0), 3), 0);
    EXPECT_EQ(0.0f * static_cast<float>(std::pow(inverse_fourth_root(0.0f), 3)), 0);
    EXPECT_EQ(0.0 * std::pow(inverse_sixth_root(0.0), 5), 0);
    EXPECT_EQ(0.0f * static_cast<float>(std::pow(inverse_sixth_root(0.0f), 5)), 0);
}

}  // namespace
}  // namespace recoat
