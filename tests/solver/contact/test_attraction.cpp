#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include <gtest/gtest.h>

#include "solver/contact/attraction.hpp"
#include "tests/support/paper_model.hpp"

namespace recoat {
namespace {

using testing::paper_model;
using testing::paper_radius;

constexpr double s_min = 1.65e-10, s_max = 1e-7;
constexpr Attraction attraction{s_min, s_max};

Coefficients pair_coefficients(double ratio = 0.001, double bond = 50) {
    return equal_sizes(paper_model(ratio, bond), paper_radius).pair;
}

/// The well of docs/physics.md section 2.4, zone by zone, in extended precision: the reference of these tests.
long double reference_well(long double s, const Coefficients& c) {
    const long double low = s_min, high = s_max, strongest = c.attraction_gap, strength = strongest * low * low;
    if (s >= high) return 0;
    if (s >= low) return strength * (1 / s - 1 / high);
    const long double edge = strength * (1 / low - 1 / high);
    if (s >= 0) return edge + strongest * (low - s);
    return edge + strongest * low - static_cast<long double>(c.attraction_contact) * s;
}

/// A separation in any of the four zones, spread over their scales.
double any_separation(std::mt19937_64& random) {
    std::uniform_real_distribution<double> unit(0, 1);
    switch (random() % 4) {
        case 0:
            return -std::pow(10, -12 + 5 * unit(random));
        case 1:
            return s_min * unit(random);
        case 2:
            return s_min * std::pow(s_max / s_min, unit(random));
        default:
            return s_max * (1 + unit(random));
    }
}

TEST(Attraction, FollowsTheFourZones) {
    const Coefficients c = pair_coefficients();
    EXPECT_DOUBLE_EQ(attraction.force(-1e-9, c), c.attraction_contact);
    EXPECT_DOUBLE_EQ(attraction.force(0.0, c), c.attraction_gap);
    EXPECT_DOUBLE_EQ(attraction.force(0.9 * s_min, c), c.attraction_gap);
    EXPECT_DOUBLE_EQ(attraction.force(2 * s_min, c), c.attraction_gap / 4);
    EXPECT_DOUBLE_EQ(attraction.force(1e-8, c), c.attraction_gap * (s_min / 1e-8) * (s_min / 1e-8));
}

TEST(Attraction, EndsAtTheCutOff) {
    const Coefficients c = pair_coefficients();
    EXPECT_GT(attraction.force(s_max, c), 0);
    EXPECT_EQ(attraction.force(std::nextafter(s_max, 1), c), 0);
    EXPECT_EQ(attraction.well(s_max, c), 0);
    EXPECT_EQ(attraction.well(1.0, c), 0);
    EXPECT_EQ(attraction.mean(1.5 * s_max, 1.2 * s_max, c), 0);
}

TEST(Attraction, WellIsTheReference) {
    const Coefficients c = pair_coefficients();
    std::mt19937_64 random(2);
    const auto depth = static_cast<double>(reference_well(0, c));
    for (int k = 0; k < 10000; ++k) {
        const double s = any_separation(random);
        EXPECT_NEAR(attraction.well(s, c), static_cast<double>(reference_well(s, c)),
                    1e-15 * depth + 1e-15 * std::fabs(s) * c.attraction_contact);
    }
}

TEST(Attraction, MeanTimesPathIsTheDifferenceOfTheWells) {
    const Coefficients c = pair_coefficients();
    std::mt19937_64 random(3);
    for (int k = 0; k < 100000; ++k) {
        const double a = any_separation(random), b = any_separation(random);
        const long double path = static_cast<long double>(a) - b;
        if (path == 0) continue;
        const long double before = reference_well(a, c), after = reference_well(b, c);
        const long double expected = (after - before) / path;
        const long double noise =
            4 * std::numeric_limits<long double>::epsilon() * std::max(before, after) / std::fabs(path);
        ASSERT_NEAR(attraction.mean(a, b, c), static_cast<double>(expected),
                    static_cast<double>(5e-13L * expected + noise))
            << "from " << a << " to " << b;
    }
}

TEST(Attraction, MeanDoesNotDependOnTheDirection) {
    const Coefficients c = pair_coefficients();
    std::mt19937_64 random(4);
    for (int k = 0; k < 10000; ++k) {
        const double a = any_separation(random), b = any_separation(random);
        const double mean = attraction.mean(a, b, c);
        ASSERT_NEAR(attraction.mean(b, a, c), mean, 1e-14 * mean);
    }
}

TEST(Attraction, MeanOverNoPathIsTheForce) {
    const Coefficients c = pair_coefficients();
    for (const double s : {-1e-9, 0.5 * s_min, 3e-10, 1e-8, 2e-7}) {
        EXPECT_EQ(attraction.mean(s, s, c), attraction.force(s, c));
        // Short paths, down to the last digit of the separation, neither jump nor lose digits.
        const double force = attraction.force(s, c);
        for (const double path : {1e-24, 1e-20, 1e-17, 1e-15})
            EXPECT_NEAR(attraction.mean(s, s + path, c), force, 1e-4 * force) << s << " " << path;
    }
}

TEST(Attraction, ForceIsTheSlopeOfTheWell) {
    const Coefficients c = pair_coefficients();
    for (const double s : {-1e-8, -1e-10, 0.3 * s_min, 0.8 * s_min, 2e-10, 1e-9, 1e-8, 5e-8}) {
        const double h = 1e-3 * std::fabs(s);
        const double slope = (attraction.well(s + h, c) - attraction.well(s - h, c)) / (2 * h);
        EXPECT_NEAR(-slope, attraction.force(s, c), 3e-6 * attraction.force(s, c)) << s;
    }
}

TEST(Attraction, WellHasNoSteps) {
    const Coefficients c = pair_coefficients();
    for (const double s : {0.0, s_min, s_max}) {
        const double gap = 1e-16;
        const double drop = attraction.well(s - gap, c) - attraction.well(s + gap, c);
        EXPECT_GE(drop, 0) << s;
        EXPECT_LE(drop, 2 * gap * c.attraction_gap * (1 + 1e-6)) << s;
    }
    // The force jumps where contact begins under stiffness scaling, and nowhere else within the range.
    EXPECT_NEAR(attraction.force(-1e-20, c) / attraction.force(0.0, c), 0.0630957, 1e-6);
    EXPECT_NEAR(attraction.force(s_min * (1 - 1e-12), c) / attraction.force(s_min * (1 + 1e-12), c), 1, 1e-11);
}

TEST(Attraction, VanishesWithoutAHamakerConstant) {
    const Coefficients c = pair_coefficients(0.001, 0);
    EXPECT_EQ(attraction.force(1e-10, c), 0);
    EXPECT_EQ(attraction.well(-1e-9, c), 0);
    EXPECT_EQ(attraction.mean(-1e-9, 1e-9, c), 0);
}

// Escape from touching without overlap: sqrt(2 G(0)/m*), the same for pair and wall [docs/physics.md section 2.4].
TEST(Attraction, EscapeSpeeds) {
    const double table[][2] = {{5, 2.54347e-4}, {50, 8.04317e-4}, {400, 2.27495e-3}};
    for (const auto& [bond, speed] : table) {
        const EqualSizes sizes = equal_sizes(paper_model(0.001, bond), paper_radius);
        for (const Coefficients& c : {sizes.pair, sizes.wall})
            EXPECT_NEAR(std::sqrt(2 * attraction.well(0.0, c) * c.inverse_mass), speed, 3e-6 * speed);
    }
}

}  // namespace
}  // namespace recoat
