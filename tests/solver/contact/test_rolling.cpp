#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "solver/contact/rolling.hpp"

namespace recoat {
namespace {

constexpr Rolling rolling{0.01};
constexpr double inertia = 7.2e-20, step = 2e-8;

Vec3 random_vector(std::mt19937_64& random, double size) {
    std::normal_distribution<double> normal;
    return size * Vec3{normal(random), normal(random), normal(random)};
}

TEST(Rolling, ProjectionTakesExactlyItsTorque) {
    const Vec3 spin = {100, -200, 200};
    const double load = 25e-6 * 3e-6;
    const Vec3 after = rolling.project(spin, load, inertia, step);
    EXPECT_NEAR(norm(spin) - norm(after), 0.01 * load * step / inertia, 1e-13 * 300);
    EXPECT_NEAR(norm(cross(spin, after)), 0, 1e-9);
}

TEST(Rolling, ProjectionNeverReversesTheSpin) {
    std::mt19937_64 random(5);
    std::uniform_real_distribution<double> exponent(-20, 0);
    int stopped = 0;
    for (int k = 0; k < 10000; ++k) {
        const Vec3 spin = random_vector(random, std::pow(10, exponent(random) / 3));
        const double load = std::pow(10, exponent(random));
        const Vec3 after = rolling.project(spin, load, inertia, step);
        ASSERT_GE(dot(spin, after), 0);
        ASSERT_LE(norm(after), norm(spin));
        stopped += norm(after) == 0;
    }
    EXPECT_GT(stopped, 1000);
    EXPECT_LT(stopped, 9000);
}

TEST(Rolling, AtRestStaysAtRest) {
    EXPECT_EQ(rolling.project({}, 1e-10, inertia, step), (Vec3{}));
    EXPECT_EQ(rolling.project({}, 0, inertia, step), (Vec3{}));
    EXPECT_EQ(rolling.relative_torque(Vec3{}, Vec3{0, 0, 1}, 1e-10, inertia, step), (Vec3{}));
}

TEST(Rolling, WithoutLoadNothingIsLost) {
    const Vec3 spin = {1, 2, 3};
    EXPECT_EQ(rolling.project(spin, 0, inertia, step), spin);
    EXPECT_EQ(norm(rolling.relative_torque(spin, Vec3{0, 0, 1}, 0.0, inertia, step)), 0);
}

TEST(Rolling, RelativeTorqueOpposesRollingButNotTwist) {
    const double load = 25e-6 * 3e-6;
    const Vec3 torque = rolling.relative_torque(Vec3{3000, 4000, 1e5}, Vec3{0, 0, 1}, load, inertia, step);
    EXPECT_NEAR(norm(torque), 0.01 * load, 1e-13 * 0.01 * load);
    EXPECT_NEAR(torque.x, -0.6 * 0.01 * load, 1e-13 * load);
    EXPECT_NEAR(torque.y, -0.8 * 0.01 * load, 1e-13 * load);
    EXPECT_EQ(torque.z, 0);
    EXPECT_EQ(norm(rolling.relative_torque(Vec3{0, 0, 1e5}, Vec3{0, 0, 1}, load, inertia, step)), 0);
}

TEST(Rolling, RelativeTorqueStopsWithinTheStepAtMost) {
    const Vec3 spin = {1e-3, 0, 0};
    const double load = 1.0;  // far more than is needed
    const Vec3 torque = rolling.relative_torque(spin, Vec3{0, 0, 1}, load, inertia, step);
    const Vec3 after = spin + (step / inertia) * torque;
    EXPECT_NEAR(norm(after), 0, 1e-15 * 1e-3 * 10);
}

}  // namespace
}  // namespace recoat
