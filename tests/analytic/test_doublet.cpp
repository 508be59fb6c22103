#include <cmath>
#include <string>

#include <gtest/gtest.h>

#include "tests/support/small_scene.hpp"
#include "tests/support/verification.hpp"

namespace recoat {
namespace {

using testing::SmallScene;
using testing::verify_relative;
namespace powder = testing::powder;

constexpr double bond = 50, turns = 100;  ///< of the pair; angular velocity [rad/s]

/// Two spheres that hold each other, turning like one rigid body about an axis across their line.
SmallScene turning(RollingForm form) {
    ContactModel model = powder::model(0.001, bond);
    model.rolling_form = form;
    SmallScene scene(model, 2e-8);
    const double force = bond * powder::weight * attraction_scaling(0.001);
    const double half =
        powder::radius - 0.5 * std::cbrt(std::pow(force / powder::hertz(0.001, 0.5 * powder::radius), 2));
    scene.sphere({-half, 0, 0}, {0, -turns * half, 0}, {0, 0, turns});
    scene.sphere({half, 0, 0}, {0, turns * half, 0}, {0, 0, turns});
    return scene;
}

// docs/physics.md sections 1.6 and 5.8: the own-spin form brakes it. Two torques mu_r R F on 2 (7/5) m R^2, F being the
// attraction less the centripetal force.
TEST(Doublet, spun_up_is_braked_by_own_spin_rolling_resistance) {
    const auto engine = turning(RollingForm::own).engine();
    engine->advance(1000);  // friction takes up the torques
    const double first = engine->particles().angular_velocity[0].z, first_time = engine->time();
    engine->advance(9000);
    const ParticleTable now = engine->particles();
    const double brake = (first - now.angular_velocity[0].z) / (engine->time() - first_time);
    const double load = powder::gravity * bond - powder::radius * first * first;
    verify_relative("braking", brake, 5.0 / 7 * powder::model().rolling_friction * load / powder::radius, 2e-3);
    verify_relative("spin of one sphere over the other's", now.angular_velocity[0].z, now.angular_velocity[1].z, 1e-13);
    const Vec3 line = now.position[1] - now.position[0], rate = now.velocity[1] - now.velocity[0];
    verify_relative("spin over that of the line", now.angular_velocity[0].z, cross(line, rate).z / dot(line, line),
                    5e-7);
}

TEST(Doublet, spun_up_is_not_braked_by_relative_rolling_resistance) {
    const auto engine = turning(RollingForm::relative).engine();
    engine->advance(10000);
    for (const Vec3 spin : engine->particles().angular_velocity) verify_relative("spin", spin.z, turns, 1e-5);
}

}  // namespace
}  // namespace recoat
