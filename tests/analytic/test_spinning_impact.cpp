#include <string>
#include <utility>

#include <gtest/gtest.h>

#include "tests/analytic/oblique_impact.hpp"
#include "tests/support/reference.hpp"
#include "tests/support/verification.hpp"

namespace recoat {
namespace {

using testing::frictional;
using testing::ObliqueImpact;
using testing::Rebound;
using testing::reference;
using testing::shortest;
using testing::verify;
namespace powder = testing::powder;

constexpr double radius = 0.1, speed = 0.2;
constexpr double spins[] = {0.26795, 0.57735, 1.0, 1.42815, 1.73205, 2.14451, 2.74748, 3.73205, 5.67128};

const ContactModel alloy = frictional(7e10, 0.33, 2700, 0.5, 0.4);
const ContactModel nylon = frictional(2.5e9, 0.4, 1000, 0.5, 0.4);
const ContactModel copper = frictional(1.2e11, 0.35, 8900, 0.5, 0.4);

/// Against the reference for the spin `psi` = w R/v_n, and the closed form where it slides all the time.
void verify_recoil(const Rebound& found, const std::string& name, double psi) {
    const std::string where = name + "." + shortest(psi);
    const double recoil = found.surface() / found.normal;
    verify("recoil of the surface over v_n'", recoil - reference(where + ".recoil"), 1e-3, where);
    if (psi < 2.1) return;
    verify("recoil while sliding over v_n'", recoil - (psi - 2.1) / 0.5, 1e-3, where);
    verify("tangential restitution while sliding", -found.surface() / (speed * psi) + (1 - 2.1 / psi), 5e-4, where);
}

// docs/physics.md section 5.5, Chung & Ooi test 6: a spinning sphere meets a rigid wall straight on. Around psi = 1.7
// the dashpot holds the contact at the limit of stick.
TEST(SpinningImpact, on_a_wall_is_chung_and_ooi_test_6) {
    for (auto [name, model] : {std::pair{"alloy", alloy}, std::pair{"nylon", nylon}}) {
        model.wall_modulus = WallModulus::rigid;
        const ObliqueImpact impact{model, radius, speed, testing::elastic_duration(model, radius, speed) / 2000};
        for (const double psi : spins) verify_recoil(impact.run(0, speed * psi), name, psi);
    }
}

// Test 7: equal spheres with opposite spins meet straight on: the surfaces do not slide on each other.
TEST(SpinningImpact, of_opposite_spins_is_chung_and_ooi_test_7) {
    for (const ContactModel& model : {alloy, copper})
        for (const double spin : {0.1, 1.0, 10.0}) {
            const double time_step = testing::elastic_duration(model, radius, speed) / 1000;
            auto scene = testing::head_on_pair(model, time_step, 3.5 * 2 * speed * time_step, 2 * speed, 2 * radius);
            scene.particles.angular_velocity = {{0, 0, spin}, {0, 0, -spin}};
            const ParticleTable after = testing::after_pair_impact(*scene.engine());
            verify("tangential velocity [m/s]", after.velocity[0].y, 3e-16);
            verify("spin, first", after.angular_velocity[0].z / spin - 1, 1e-14);
            verify("spin, second", after.angular_velocity[1].z / -spin - 1, 1e-14);
            verify("rebound speed over e v", after.velocity[1].x / (0.5 * speed) - 1, 2e-4);
        }
}

// Test 8: a spinning sphere meets one at rest of 1.25e5 times its mass; the result does not depend on the moduli or on
// how the mass is made up (here by fifty times the radius, there by density): that of test 6 but for the mass ratio.
TEST(SpinningImpact, on_a_heavy_sphere_is_chung_and_ooi_test_8) {
    const double time_step = testing::elastic_duration(alloy, radius, speed) / 2000;
    for (const double psi : spins) {
        ContactModel model = alloy;
        model.lever_arm = LeverArm::radius;
        testing::SmallScene scene(model, time_step, 100 * radius);
        const double apart = 51 * radius + 3.5 * speed * time_step;
        scene.sphere({0, 0, 0}, {}, {}, 50 * radius);
        scene.sphere({0, 0, apart}, {0, 0, -speed}, {0, -speed * psi / radius, 0}, radius);
        const ParticleTable after = testing::after_pair_impact(*scene.engine());
        verify_recoil({after.velocity[1].z, after.velocity[1].x, -after.angular_velocity[1].y * radius}, "alloy", psi);
        verify("momentum of the heavy sphere over what the light one lost",
               after.velocity[0].z * 1.25e5 / -(speed + after.velocity[1].z) - 1, 3e-13);
    }
}

}  // namespace
}  // namespace recoat
