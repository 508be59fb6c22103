#include <limits>
#include <random>

#include <gtest/gtest.h>

#include "analyzer/fields/sphere_box.hpp"
#include "tests/analyzer/slice_integral.hpp"

namespace recoat {
namespace {

using testing::sphere_box_by_slices;

constexpr double infinite = std::numeric_limits<double>::infinity();
constexpr double pi = std::numbers::pi;

class Random {
public:
    double operator()(double low, double high) { return std::uniform_real_distribution<double>(low, high)(generator_); }

private:
    std::mt19937_64 generator_{7};
};

TEST(SphereBox, AgreesWithSlicesOnRandomBoxes) {
    Random random;
    for (int trial = 0; trial < 400; ++trial) {
        const double radius = random(0.2, 2);
        const Vec3 centre = {random(-1, 1), random(-1, 1), random(-1, 1)};
        const Vec3 lower = {random(-2, 1), random(-2, 1), random(-2, 1)};
        const Vec3 upper = lower + Vec3{random(0, 3), random(0, 3), random(0, 3)};
        EXPECT_NEAR(sphere_box_volume(centre, radius, lower, upper), sphere_box_by_slices(centre, radius, lower, upper),
                    2e-13 * sphere_volume(radius));
    }
}

TEST(SphereBox, PartsAddUpToTheSphere) {
    Random random;
    for (int trial = 0; trial < 2000; ++trial) {
        const Vec3 cut = {random(-1.1, 1.1), random(-1.1, 1.1), random(-1.1, 1.1)};
        double sum = 0;
        for (int part = 0; part < 8; ++part) {
            const auto low = [&](int axis, double at) { return (part >> axis & 1) != 0 ? at : -infinite; };
            const auto high = [&](int axis, double at) { return (part >> axis & 1) != 0 ? infinite : at; };
            sum += sphere_box_volume({0, 0, 0}, 1, {low(0, cut.x), low(1, cut.y), low(2, cut.z)},
                                     {high(0, cut.x), high(1, cut.y), high(2, cut.z)});
        }
        EXPECT_NEAR(sum, 4 * pi / 3, 1e-14);
    }
}

TEST(SphereBox, FinePartsOfABoxAddUpToIt) {
    Random random;
    const Vec3 lower = {-0.8, -0.7, -0.9}, upper = {0.7, 0.95, 0.6};
    for (int trial = 0; trial < 20; ++trial) {
        const Vec3 centre = {random(-0.3, 0.3), random(-0.3, 0.3), random(-0.3, 0.3)};
        double sum = 0;
        constexpr int parts = 5;
        const auto at = [&](double low, double high, int k) { return low + (high - low) * k / parts; };
        for (int i = 0; i < parts; ++i) {
            for (int j = 0; j < parts; ++j) {
                for (int k = 0; k < parts; ++k) {
                    const auto corner = [&](int a, int b, int c) {
                        return Vec3{at(lower.x, upper.x, a), at(lower.y, upper.y, b), at(lower.z, upper.z, c)};
                    };
                    sum += sphere_box_volume(centre, 1, corner(i, j, k), corner(i + 1, j + 1, k + 1));
                }
            }
        }
        EXPECT_NEAR(sum, sphere_box_volume(centre, 1, lower, upper), 1e-13);
    }
}

TEST(SphereBox, KnownVolumes) {
    const Vec3 nowhere = {-infinite, -infinite, -infinite}, everywhere = {infinite, infinite, infinite};
    EXPECT_DOUBLE_EQ(sphere_box_volume({3, 4, 5}, 2, nowhere, everywhere), 32 * pi / 3);
    EXPECT_NEAR(sphere_box_volume({0, 0, 0}, 1, {0, -infinite, -infinite}, everywhere), 2 * pi / 3, 1e-15);
    EXPECT_NEAR(sphere_box_volume({0, 0, 0}, 1, {0, 0, 0}, everywhere), pi / 6, 1e-15);
    EXPECT_NEAR(sphere_box_volume({0, 0, 0}, 1, {0.5, -1, -1}, {1, 1, 1}), pi * 0.25 * 2.5 / 3, 1e-15);
    EXPECT_NEAR(sphere_box_volume({0, 0, 0}, 2, {-1, -1, -1}, {1, 1, 1}), 8, 1e-14);  // the box lies within
    EXPECT_NEAR(sphere_box_volume({0.5, 0, 0}, 0.5, {0, -1, -1}, {2, 0, 1}), pi / 12, 1e-15);
}

TEST(SphereBox, TangentFacesEdgesAndCornersCutNothing) {
    EXPECT_DOUBLE_EQ(sphere_box_volume({0, 0, 0}, 1, {-1, -1, -1}, {1, 1, 1}), 4 * pi / 3);
    EXPECT_EQ(sphere_box_volume({0, 0, 0}, 1, {1, -1, -1}, {2, 1, 1}), 0);
    EXPECT_EQ(sphere_box_volume({0, 0, 0}, 1, {0.6, 0.8, -1}, {2, 2, 1}), 0);  // the edge touches the sphere
    const double third = 1 / std::sqrt(3.0);
    EXPECT_NEAR(sphere_box_volume({0, 0, 0}, 1, {third, third, third}, {2, 2, 2}), 0, 1e-15);
    EXPECT_EQ(sphere_box_volume({0, 0, 0}, 1, {-2, -2, -2}, {-0.6, -0.8, 2}), 0);
}

TEST(SphereBox, PlanesThroughTheCentreHalveTheVolume) {
    for (const double a : {-0.9, -0.3, 0.0, 0.3, 0.9}) {
        for (const double b : {-0.8, 0.0, 0.5}) {
            EXPECT_NEAR(ball_corner(a, b, 0), 0.5 * ball_corner(a, b, -1), 1e-15);
            EXPECT_NEAR(ball_corner(a, 0, b), ball_corner(0, b, a), 1e-15);
        }
    }
}

TEST(SphereBox, NearlyTangentCornersVaryContinuously) {
    for (const double gap : {1e-3, 1e-6, 1e-9, 1e-12}) {
        // A slightly cut cap: pi gap^2 (1 - gap/3).
        EXPECT_NEAR(ball_corner(1 - gap, -1, -1), pi * gap * gap * (1 - gap / 3), 1e-15);
        EXPECT_NEAR(ball_corner(1 - gap, 0, 0), pi * gap * gap * (1 - gap / 3) / 4, 1e-15);
        EXPECT_NEAR(ball_corner(0.6 - gap, 0.8 - gap, -1),
                    sphere_box_by_slices({0, 0, 0}, 1, {0.6 - gap, 0.8 - gap, -1}, {1, 1, 1}), 1e-14);
    }
}

TEST(SphereBox, DistanceToAnInterval) {
    EXPECT_EQ(squared_distance_to_interval(2, 3, 5), 1);
    EXPECT_EQ(squared_distance_to_interval(4, 3, 5), 0);
    EXPECT_EQ(squared_distance_to_interval(7, 3, 5), 4);
}

}  // namespace
}  // namespace recoat
