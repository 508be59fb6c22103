#include <gtest/gtest.h>

#include "solver/contact/kinematics.hpp"

namespace recoat {
namespace {

constexpr double radius = 25e-6;

void expect_near(Vec3 a, Vec3 b, double tolerance) { EXPECT_LT(norm(a - b), tolerance); }

TEST(Kinematics, ApproachIsANegativeRate) {
    // The first moves towards the second, which lies in +x.
    const Kinematics k = kinematics(Vec3{1, 0, 0}, -1e-9, Vec3{0.1, 0, 0}, Vec3{});
    EXPECT_EQ(k.closing_rate, -0.1);
    expect_near(k.sliding_velocity, {}, 1e-18);
}

TEST(Kinematics, RollingOnAFloorDoesNotSlide) {
    // Towards +x over a floor below: the spin is about +y.
    const double speed = 0.05;
    const Kinematics k = kinematics(Vec3{0, 0, -1}, 0.0, Vec3{speed, 0, 0}, radius * Vec3{0, speed / radius, 0});
    expect_near(k.sliding_velocity, {}, 1e-16);
    EXPECT_EQ(k.closing_rate, 0);
}

TEST(Kinematics, SpinningInPlaceSlides) {
    const Kinematics k = kinematics(Vec3{0, 0, -1}, 0.0, Vec3{}, radius * Vec3{0, 100, 0});
    // The lowest point of a sphere turning about +y moves towards -x.
    expect_near(k.sliding_velocity, {-100 * radius, 0, 0}, 1e-16);
}

TEST(Kinematics, GearsDoNotSlideAndTheSlidingIsTangential) {
    const Vec3 normal = {0.6, 0, 0.8};
    const Vec3 spin = {30, -200, 10};
    const Kinematics gears = kinematics(normal, 0.0, Vec3{}, radius * spin + radius * (-spin));
    expect_near(gears.sliding_velocity, {}, 1e-18);
    const Kinematics any = kinematics(normal, 0.0, Vec3{0.01, 0.02, -0.03}, radius * spin);
    EXPECT_NEAR(dot(any.sliding_velocity, normal), 0, 1e-17);
    EXPECT_NEAR(any.closing_rate, -dot(Vec3{0.01, 0.02, -0.03}, normal), 1e-17);
}

// A pair that turns as one rigid body neither slides nor closes.
TEST(Kinematics, RigidRotationOfAPairIsNoMotion) {
    const Vec3 turn = {10, -40, 25}, normal = {0.48, 0.6, 0.64};
    const double first = 25e-6, second = 40e-6;
    const Vec3 relative = cross(turn, -(first + second) * normal);  // of the first centre to the second
    const Kinematics k = kinematics(normal, 0.0, relative, first * turn + second * turn);
    EXPECT_NEAR(k.closing_rate, 0, 1e-17);
    expect_near(k.sliding_velocity, {}, 1e-17);
}

}  // namespace
}  // namespace recoat
