#include <cmath>
#include <utility>

#include <gtest/gtest.h>

#include "tests/support/reference.hpp"
#include "tests/support/small_scene.hpp"

namespace recoat {
namespace {

using testing::over_plane;
using testing::reference;
using testing::SmallScene;
namespace powder = testing::powder;

/// An oblique, spinning, cohesive pair that meets and parts.
SmallScene oblique_pair(double bond) {
    SmallScene scene(powder::model(0.001, bond), 2e-8);
    scene.sphere({-25.5e-6, -12e-6, 3e-6}, {0.06, 0.01, 0}, {200, -300, 400});
    scene.sphere({19e-6, 10e-6, -4e-6}, {-0.05, 0, 0.02}, {-100, 500, 100});
    return scene;
}

constexpr std::int64_t flight = 2000;  // steps: 40 us, 4 um at the relative speed, through the whole contact

void expect_near(Vec3 found, Vec3 expected, double tolerance) {
    EXPECT_NEAR(norm(found - expected), 0, tolerance) << found.x << ' ' << found.y << ' ' << found.z << " for "
                                                      << expected.x << ' ' << expected.y << ' ' << expected.z;
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
    for (const double bond : {0.0, 50.0}) {
        const SmallScene still = oblique_pair(bond);
        SmallScene moving = still;
        const Vec3 frame = {1, -0.5, 0.3};
        for (Vec3& velocity : moving.particles.velocity) velocity += frame;
        const ParticleTable a = fly(still), b = fly(moving);
        for (std::size_t i = 0; i < 2; ++i) {
            expect_near(b.velocity[i] - frame, a.velocity[i], 1e-8);
            expect_near(b.angular_velocity[i], a.angular_velocity[i], 1e-3);
        }
    }
}

Vec3 turned(Vec3 v) {
    // Rotation by 1 about z, then by 0.7 about x.
    const double c = std::cos(1.0), s = std::sin(1.0), C = std::cos(0.7), S = std::sin(0.7);
    const Vec3 first = {c * v.x - s * v.y, s * v.x + c * v.y, v.z};
    return {first.x, C * first.y - S * first.z, S * first.y + C * first.z};
}

TEST(Invariance, under_rotation) {
    for (const double bond : {0.0, 50.0}) {
        const SmallScene straight = oblique_pair(bond);
        SmallScene rotated = straight;
        for (auto* vectors :
             {&rotated.particles.position, &rotated.particles.velocity, &rotated.particles.angular_velocity})
            for (Vec3& v : *vectors) v = turned(v);
        const ParticleTable a = fly(straight), b = fly(rotated);
        for (std::size_t i = 0; i < 2; ++i) {
            expect_near(b.position[i], turned(a.position[i]), 1e-13);
            expect_near(b.velocity[i], turned(a.velocity[i]), 1e-8);
            expect_near(b.angular_velocity[i], turned(a.angular_velocity[i]), 1e-3);
        }
    }
}

TEST(Invariance, under_exchange_of_the_spheres) {
    for (const double bond : {0.0, 50.0}) {
        const SmallScene scene = oblique_pair(bond);
        SmallScene exchanged = scene;
        for (auto* vectors :
             {&exchanged.particles.position, &exchanged.particles.velocity, &exchanged.particles.angular_velocity})
            std::swap((*vectors)[0], (*vectors)[1]);
        const ParticleTable a = fly(scene), b = fly(exchanged);
        expect_near(b.velocity[0], a.velocity[1], 1e-12);
        expect_near(b.angular_velocity[0], a.angular_velocity[1], 1e-7);
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
        for (std::size_t i = 0; i < 2; ++i) {
            expect_near(b.velocity[i], a.velocity[i], 1e-8);
            expect_near(b.angular_velocity[i], a.angular_velocity[i], 1e-3);
            EXPECT_GE(b.position[i].y, -1e-4);
            EXPECT_LT(b.position[i].y, 4e-4);
            const double shift = b.position[i].y - a.position[i].y - 4e-4;
            EXPECT_NEAR(shift / 5e-4, std::round(shift / 5e-4), 1e-9);
        }
    }
}

// Leapfrog with a half kick at the start: free fall is exact, but for the rounding of some 10^6 steps.
TEST(FreeFall, is_exact_to_round_off) {
    SmallScene scene(powder::model(0.001, 50), 2e-8);
    scene.setup.gravity = {0, 0, -powder::gravity};
    scene.sphere({0, 0, 0}, {0.01, 0, 0.02});
    const auto engine = scene.engine();
    engine->advance(713921);
    const double t = 713921 * 2e-8;  // 1 mm from rest
    const ParticleTable now = engine->particles();
    EXPECT_NEAR(now.position[0].z, 0.02 * t - 0.5 * powder::gravity * t * t, 1e-13);
    EXPECT_NEAR(now.position[0].x, 0.01 * t, 1e-14);
    EXPECT_NEAR(now.velocity[0].z, 0.02 - powder::gravity * t, 1e-11);
}

// Weight on a wall, and a pair or a wall that holds by attraction, settle at the overlaps of the closed forms.
TEST(StaticOverlap, of_the_weight_is_that_of_hertz) {
    for (const double ratio : {1.0, 0.001}) {
        auto scene = over_plane(powder::model(ratio), ratio == 1 ? 2e-9 : 2e-8, 0, {});
        scene.setup.gravity = {0, 0, -powder::gravity};
        const auto engine = scene.engine();
        engine->advance(200000);
        const double overlap = powder::radius - engine->particles().position[0].z;
        const double expected = reference("weight.overlap") * std::pow(ratio, -2.0 / 3);
        EXPECT_NEAR(overlap / expected, 1, 1e-4) << ratio;
        EXPECT_NEAR(engine->contacts().at(0).normal_force / powder::weight, 1, 1e-4);
    }
}

TEST(StaticOverlap, of_the_attraction_scales_with_the_stiffness) {
    for (const int bond : {5, 50, 400})
        for (const double ratio : {0.1, 0.001}) {
            const auto model = powder::model(ratio, bond);
            const auto pair = testing::head_on_pair(model, 2e-8, 0, 0).engine();
            const auto wall = over_plane(model, 2e-8, 0, {}).engine();
            pair->advance(20000);
            wall->advance(20000);
            const double scale = std::pow(ratio, -0.4);
            const std::string name = std::to_string(bond);
            EXPECT_NEAR(-testing::pair_separation(pair->particles()) / (scale * reference("equilibrium.pair." + name)),
                        1, 1e-4);
            EXPECT_NEAR(
                (powder::radius - wall->particles().position[0].z) / (scale * reference("equilibrium.wall." + name)), 1,
                1e-4);
        }
}

}  // namespace
}  // namespace recoat
