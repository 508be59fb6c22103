#include <cmath>
#include <string>
#include <utility>

#include <gtest/gtest.h>

#include "tests/support/small_scene.hpp"
#include "tests/support/verification.hpp"

namespace recoat {
namespace {

using testing::after_pair_impact;
using testing::pair_rate;
using testing::SmallScene;
using testing::verify;
using testing::verify_relative;
namespace powder = testing::powder;

constexpr double small = 15e-6, large = 40e-6;

SmallScene unequal_pair(const ContactModel& model, double time_step, double offset) {
    SmallScene scene(model, time_step, 2 * large);
    const double reach = small + large, along = std::sqrt(1 - offset * offset);
    scene.sphere({0, 0, 0}, {0.05, 0, 0}, {}, small);
    scene.sphere({along * reach + 5e-9, offset * reach, 0}, {-0.05, 0, 0}, {}, large);
    return scene;
}

ContactModel without_rolling() {
    ContactModel model = powder::model();
    model.rolling_friction = 0;
    return model;
}

TEST(UnequalRadii, restitution_is_the_same) {
    for (const double e : {0.4, 0.8}) {
        ContactModel model = without_rolling();
        model.restitution = e;
        const SmallScene scene = unequal_pair(model, 1e-8, 0);
        verify("restitution, absolute", pair_rate(after_pair_impact(*scene.engine())) / 0.1 - e, 1e-3);
    }
}

// The largest overlap follows from R*, m* and E* of the pair, and of each sphere with a wall.
TEST(UnequalRadii, overlap_is_that_of_hertz) {
    ContactModel model = without_rolling();
    model.restitution = 1;
    const double m = sphere_mass(small, powder::density), n = sphere_mass(large, powder::density);
    const auto deepest = [](double mass, double radius, double speed) {
        return std::pow(1.25 * mass * speed * speed / powder::hertz(0.001, radius), 0.4);
    };
    const auto engine = unequal_pair(model, 1e-8, 0).engine();
    after_pair_impact(*engine);
    verify_relative("overlap of a pair", engine->largest_overlap() * 2 * large,
                    deepest(m * n / (m + n), small * large / (small + large), 0.1), 3e-4);
    for (const double radius : {small, large}) {
        SmallScene scene(model, 1e-8, 2 * large);
        scene.plane({0, 0, 0}, {0, 0, 1});
        scene.sphere({0, 0, radius + 5e-9}, {0, 0, -0.05}, {}, radius);
        scene.sphere({1, 0, 1}, {}, {}, 20e-6);
        const auto wall = scene.engine();
        testing::after_plane_impact(*wall);
        verify_relative("overlap with a wall", wall->largest_overlap() * 2 * large,
                        deepest(sphere_mass(radius, powder::density), radius, 0.05), 3e-4);
    }
}

TEST(UnequalRadii, momenta_are_conserved) {
    for (const double bond : {0.0, 50.0}) {
        ContactModel model = without_rolling();
        model.hamaker = powder::model(1, bond).hamaker;
        SmallScene scene = unequal_pair(model, 1e-8, 0.6);
        scene.particles.angular_velocity = {{300, -200, 500}, {100, 400, -100}};
        const auto momenta = [](const ParticleTable& p) {
            Vec3 linear, angular;
            for (std::size_t i = 0; i < 2; ++i) {
                const double mass = sphere_mass(p.radius[i], powder::density);
                linear += mass * p.velocity[i];
                angular += mass * cross(p.position[i], p.velocity[i]) +
                           sphere_inertia(mass, p.radius[i]) * p.angular_velocity[i];
            }
            return std::pair{linear, angular};
        };
        const auto before = momenta(scene.particles);
        const auto after = momenta(after_pair_impact(*scene.engine()));
        verify("momentum", norm(after.first - before.first) / norm(before.first), 1e-13);
        verify(bond > 0 ? "angular momentum, with attraction" : "angular momentum",
               norm(after.second - before.second) / norm(before.second), bond > 0 ? 2e-7 : 1e-13);
    }
}

// Spheres of one radius take the same way whether the engine knows that they are alike or, because of a different
// sphere far away, does not.
TEST(UnequalRadii, agree_with_equal_radii_where_they_are_equal) {
    for (const double bond : {0.0, 50.0})
        for (const RollingForm form : {RollingForm::own, RollingForm::relative}) {
            ContactModel model = powder::model(0.001, bond);
            model.rolling_form = form;
            SmallScene alike(model, 2e-8);
            alike.setup.gravity = {0, 0, -powder::gravity};
            alike.plane({0, 0, 0}, {0, 0, 1});
            alike.sphere({0, 0, 1.002 * powder::radius}, {0.05, 0, -0.01}, {100, 200, 300});
            alike.sphere({2.02 * powder::radius, 1e-6, 1.5 * powder::radius}, {-0.05, 0, 0}, {});
            SmallScene mixed = alike;
            mixed.sphere({1e-2, 0, 1e-2}, {}, {}, 0.9 * powder::radius);
            const auto a = alike.engine(), b = mixed.engine();
            a->advance(4000);
            b->advance(4000);
            EXPECT_GT(a->largest_overlap(), 1e-4);
            const ParticleTable p = a->particles(), q = b->particles();
            for (std::size_t i = 0; i < 2; ++i) {
                verify("velocity [m/s]", norm(p.velocity[i] - q.velocity[i]), 3e-16);
                verify("spin [rad/s]", norm(p.angular_velocity[i] - q.angular_velocity[i]), 2e-11);
            }
        }
}

// Where it slides all the time, friction is mu times the normal impulse, and each
// sphere is turned by it at its own radius.
TEST(UnequalRadii, sliding_impulse_is_shared_by_mass_and_radius) {
    ContactModel model = without_rolling();
    model.stiffness_ratio = 1;  // a short contact, during which the normal hardly turns
    SmallScene scene(model, 5e-10, 2 * large);
    scene.sphere({0, 0, 0}, {0.05, 0.12, 0}, {}, small);
    scene.sphere({small + large + 1e-10, 0, 0}, {0, 0, 0}, {}, large);
    const ParticleTable after = after_pair_impact(*scene.engine());
    const double m = sphere_mass(small, powder::density), n = sphere_mass(large, powder::density);
    const double impulse = m * n / (m + n) * 1.4 * 0.05, friction = 0.3 * impulse;
    verify_relative("normal, first", (0.05 - after.velocity[0].x) * m, impulse, 5e-3);
    verify_relative("normal, second", after.velocity[1].x * n, impulse, 5e-3);
    verify_relative("tangential, first", (0.12 - after.velocity[0].y) * m, friction, 5e-3);
    verify_relative("tangential, second", after.velocity[1].y * n, friction, 5e-3);
    verify_relative("spin, first", after.angular_velocity[0].z * sphere_inertia(m, small) / small, -friction, 5e-3);
    verify_relative("spin, second", after.angular_velocity[1].z * sphere_inertia(n, large) / large, -friction, 5e-3);
}

}  // namespace
}  // namespace recoat
