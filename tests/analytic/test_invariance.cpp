#include <cmath>
#include <numbers>
#include <random>
#include <string>
#include <utility>

#include <gtest/gtest.h>

#include "tests/support/small_scene.hpp"
#include "tests/support/verification.hpp"

namespace recoat {
namespace {

using testing::SmallScene;
using testing::verify;
namespace powder = testing::powder;

/// An oblique, spinning, cohesive pair that meets and parts.
SmallScene oblique_pair(double bond) {
    SmallScene scene(powder::model(0.001, bond), 2e-8);
    scene.sphere({-25.5e-6, -12e-6, 3e-6}, {0.06, 0.01, 0}, {200, -300, 400});
    scene.sphere({19e-6, 10e-6, -4e-6}, {-0.05, 0, 0.02}, {-100, 500, 100});
    return scene;
}

constexpr std::int64_t flight = 2000;  // steps: 40 us, 4 um at the relative speed, through the whole contact

/// After the flight, in units of the speed and of the spin that gives the surface that speed.
void verify_same(const ParticleTable& found, const ParticleTable& expected, double tolerance, double bond) {
    const std::string where = "Bo " + std::to_string(bond);
    for (std::size_t i = 0; i < 2; ++i) {
        verify("velocity over 0.05 m/s", norm(found.velocity[i] - expected.velocity[i]) / 0.05, tolerance, where);
        verify("spin over 0.05 m/s on the surface",
               norm(found.angular_velocity[i] - expected.angular_velocity[i]) * powder::radius / 0.05, tolerance,
               where);
    }
}

/// The outcome of `scene` after the flight, and whether the spheres touched on the way.
ParticleTable fly(const SmallScene& scene) {
    const auto engine = scene.engine();
    engine->advance(flight);
    EXPECT_GT(engine->largest_overlap(), 1e-4);
    return engine->particles();
}

// docs/physics.md section 5.8: adding 1 m/s changes nothing. Positions round to 1e-20 m: relative to overlaps of 1e-8.
TEST(Invariance, under_a_moving_frame) {
    for (const double bond : {0.0, 50.0})
        for (const Vec3 frame : {Vec3{1, 0, 0}, Vec3{0, -1, 0}, Vec3{0, 0, 1}, Vec3{1, -0.5, 0.3}}) {
            const SmallScene still = oblique_pair(bond);
            SmallScene moving = still;
            for (Vec3& velocity : moving.particles.velocity) velocity += frame;
            ParticleTable seen = fly(moving);
            for (Vec3& velocity : seen.velocity) velocity += -1.0 * frame;
            verify_same(seen, fly(still), 5e-12, bond);
        }
}

/// Rotation by `angle` about the unit vector `axis` [Rodrigues].
Vec3 turned(Vec3 v, Vec3 axis, double angle) {
    const double c = std::cos(angle);
    return c * v + std::sin(angle) * cross(axis, v) + (1 - c) * dot(axis, v) * axis;
}

TEST(Invariance, under_rotation) {
    std::mt19937_64 random(1);
    std::normal_distribution<double> normal;
    for (const double bond : {0.0, 50.0})
        for (int k = 0; k < 10; ++k) {
            Vec3 axis = {normal(random), normal(random), normal(random)};
            axis = (1 / norm(axis)) * axis;
            const double angle = std::numbers::pi * normal(random);
            const auto turn = [&](ParticleTable& table) {
                for (auto* vectors : {&table.position, &table.velocity, &table.angular_velocity})
                    for (Vec3& v : *vectors) v = turned(v, axis, angle);
            };
            SmallScene rotated = oblique_pair(bond);
            turn(rotated.particles);
            ParticleTable expected = fly(oblique_pair(bond));
            turn(expected);
            const ParticleTable found = fly(rotated);
            verify_same(found, expected, 5e-12, bond);
            for (std::size_t i = 0; i < 2; ++i)
                verify("position [m]", norm(found.position[i] - expected.position[i]), 3e-16);
        }
}

TEST(Invariance, under_exchange_of_the_spheres) {
    for (const double bond : {0.0, 50.0}) {
        const auto exchange = [](ParticleTable& table) {
            for (auto* vectors : {&table.position, &table.velocity, &table.angular_velocity})
                std::swap((*vectors)[0], (*vectors)[1]);
        };
        SmallScene exchanged = oblique_pair(bond);
        exchange(exchanged.particles);
        ParticleTable found = fly(exchanged);
        exchange(found);
        verify_same(found, fly(oblique_pair(bond)), 5e-15, bond);
    }
}

// The pair meets across the end of the period.
TEST(Invariance, across_the_period) {
    for (const double bond : {0.0, 50.0}) {
        const SmallScene scene = oblique_pair(bond);
        SmallScene split = scene;
        split.setup.y_min = -1e-4;
        split.setup.y_period = 5e-4;
        for (Vec3& x : split.particles.position) x.y += 4e-4;  // the first is at 3.88e-4, the second at 4.1e-4 - period
        split.particles.position[1].y -= 5e-4;
        const ParticleTable a = fly(scene), b = fly(split);
        verify_same(b, a, 3e-11, bond);
        for (std::size_t i = 0; i < 2; ++i) {
            EXPECT_GE(b.position[i].y, -1e-4);
            EXPECT_LT(b.position[i].y, 4e-4);
            const double shift = (b.position[i].y - a.position[i].y - 4e-4) / 5e-4;
            verify("place over the period, modulo 1", shift - std::round(shift), 5e-12);
        }
    }
}

}  // namespace
}  // namespace recoat
