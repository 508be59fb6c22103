#include <cmath>
#include <string>

#include <gtest/gtest.h>

#include "tests/support/reference.hpp"
#include "tests/support/small_scene.hpp"
#include "tests/support/verification.hpp"

namespace recoat {
namespace {

using testing::reference;
using testing::SmallScene;
using testing::verify;
using testing::verify_relative;
namespace powder = testing::powder;

/// Spheres at +-0.05 m/s along x, the second `offset` diameters above the first, `ahead` [m] before they touch.
SmallScene oblique_pair(const ContactModel& model, double time_step, double offset, double ahead) {
    SmallScene scene(model, time_step);
    const double height = 0.5 * offset * powder::diameter;
    const double half = 0.5 * (std::sqrt(1 - offset * offset) * powder::diameter + ahead);
    scene.sphere({-half, -height, 0}, {0.05, 0, 0});
    scene.sphere({half, height, 0}, {-0.05, 0, 0});
    return scene;
}

ContactModel without_rolling(double ratio) {
    ContactModel model = powder::model(ratio);
    model.rolling_friction = 0;
    return model;
}

/// Time from first touch, which lies between steps, to the end of the overlap of an oblique pair without attraction
/// [s].
double contact_time(const SmallScene& scene, double ahead, double closing_speed) {
    const auto engine = scene.engine();
    ParticleTable now;
    do {
        engine->advance(1);
        now = engine->particles();
    } while (testing::pair_separation(now) < 0 || testing::pair_rate(now) < 0);
    return engine->time() - testing::pair_separation(now) / testing::pair_rate(now) - ahead / closing_speed;
}

// docs/physics.md section 5.7.
TEST(ObliquePair, is_that_of_the_reference) {
    for (const std::string ratio : {"1", "0.001"})
        for (const std::string offset : {"0.1", "0.5", "0.9"}) {
            const double time_step = ratio == "1" ? 1.25e-9 : 2e-8, ahead = 3.4 * 0.1 * time_step;
            const auto scene = oblique_pair(without_rolling(std::stod(ratio)), time_step, std::stod(offset), ahead);
            const ParticleTable after = testing::after_pair_impact(*scene.engine());
            const auto expected = [&](const char* what) { return reference("oblique." + ratio + "." + offset + what); };
            const std::string where = "r = " + ratio + ", offset " + offset;
            verify("x velocity over 0.05 m/s", (after.velocity[0].x - expected(".x")) / 0.05, 1e-3, where);
            verify("y velocity over 0.05 m/s", (after.velocity[0].y - expected(".y")) / 0.05, 1e-3, where);
            verify_relative("spin", after.angular_velocity[0].z, expected(".spin"), 1e-3, where);
            verify_relative("spin of the second over that of the first", after.angular_velocity[1].z,
                            after.angular_velocity[0].z, 1e-13, where);
            verify("sum of the velocities [m/s]", after.velocity[1].x + after.velocity[0].x, 1e-15, where);
            verify_relative("duration", contact_time(scene, ahead, 0.1), expected(".duration"), 1e-3, where);
        }
}

/// Linear and angular momentum [kg m/s, kg m2/s] of spheres of the powder's density.
std::pair<Vec3, Vec3> momenta(const ParticleTable& p) {
    Vec3 linear, angular;
    for (std::size_t i = 0; i < p.size(); ++i) {
        const double mass = sphere_mass(p.radius[i], powder::density);
        linear += mass * p.velocity[i];
        angular +=
            mass * cross(p.position[i], p.velocity[i]) + sphere_inertia(mass, p.radius[i]) * p.angular_velocity[i];
    }
    return {linear, angular};
}

struct Change {
    double linear = 0, angular = 0;  ///< over momentum and angular momentum of one sphere
};

Change change_of_momenta(const ContactModel& model, double bond) {
    ContactModel used = model;
    used.hamaker = powder::model(1, bond).hamaker;
    SmallScene scene = oblique_pair(used, 2e-8, 0.6, 1e-8);
    scene.particles.angular_velocity = {{300, -200, 500}, {100, 400, -100}};
    scene.particles.velocity[0].z = 0.01;
    const auto [linear, angular] = momenta(scene.particles);
    const ParticleTable after = testing::after_pair_impact(*scene.engine());
    const auto [linear_after, angular_after] = momenta(after);
    const double unit = powder::mass * 0.05;
    return {norm(linear_after - linear) / unit, norm(angular_after - angular) / (unit * powder::radius)};
}

// Forces of a pair are opposite to round-off; with the arm to the contact point so are their moments. Only the impulse
// of the attraction acts along the normal of the step's start while the pair turns: an error of the order of the step.
TEST(ObliquePair, conserves_both_momenta) {
    for (const double bond : {0.0, 50.0})
        for (const RollingForm form : {RollingForm::own, RollingForm::relative}) {
            ContactModel model = without_rolling(0.001);
            model.rolling_form = form;
            if (form == RollingForm::relative) model.rolling_friction = 0.01;
            const Change change = change_of_momenta(model, bond);
            verify("momentum over m v", change.linear, 1e-14);
            if (bond > 0)
                verify("angular momentum over m v R, with attraction", change.angular, 6e-7);
            else
                verify("angular momentum over m v R", change.angular, 1e-13);
        }
}

// Section 1.2: the paper's arm, the radius, breaks angular momentum by what the reference says; own-spin rolling too.
TEST(ObliquePair, loses_angular_momentum_with_the_arm_of_the_paper) {
    for (const std::string ratio : {"1", "0.001"})
        for (const std::string offset : {"0.1", "0.5", "0.9"}) {
            ContactModel model = without_rolling(std::stod(ratio));
            model.lever_arm = LeverArm::radius;
            const double time_step = ratio == "1" ? 1.25e-9 : 2e-8;
            const SmallScene scene = oblique_pair(model, time_step, std::stod(offset), 3.4 * 0.1 * time_step);
            const double before = norm(momenta(scene.particles).second);
            const double found = norm(momenta(testing::after_pair_impact(*scene.engine())).second) / before - 1;
            verify_relative("change of angular momentum", found,
                            reference("oblique." + ratio + "." + offset + ".radius_arm"), 0.01, ratio + " " + offset);
        }
    ContactModel rolling = without_rolling(0.001);
    rolling.rolling_friction = 0.01;
    EXPECT_GT(change_of_momenta(rolling, 0).angular, 1e-6);
}

}  // namespace
}  // namespace recoat
