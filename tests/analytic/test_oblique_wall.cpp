#include <cmath>
#include <numbers>
#include <string>

#include <gtest/gtest.h>

#include "tests/support/reference.hpp"
#include "tests/support/small_scene.hpp"

namespace recoat {
namespace {

using testing::after_plane_impact;
using testing::over_plane;
using testing::reference;
namespace powder = testing::powder;

/// An impact on the plane z = 0 and what it depends on; the arm is the radius, as in the closed forms.
struct Impact {
    ContactModel model;
    double radius, normal_speed, time_step;

    struct Outcome {
        double normal, tangential, spin, surface;  ///< [m/s]; spin times radius; at the contact point
    };

    /// `tangential` along x; `spin` times the radius adds to it at the contact point [m/s].
    [[nodiscard]] Outcome run(double tangential, double spin = 0) const {
        ContactModel used = model;
        used.lever_arm = LeverArm::radius;
        // Contact point below the centre: its velocity is v - w_y R along x.
        const auto scene = over_plane(used, time_step, 3.5 * normal_speed * time_step, {tangential, 0, -normal_speed},
                                      {0, -spin / radius, 0}, 2 * radius);
        const ParticleTable after = after_plane_impact(*scene.engine());
        const double turned = -after.angular_velocity[0].y * radius;
        return {after.velocity[0].z, after.velocity[0].x, turned, after.velocity[0].x + turned};
    }
};

ContactModel material(double youngs_modulus, double poisson_ratio, double density, double restitution,
                      double sliding_friction) {
    ContactModel model;
    model.youngs_modulus = youngs_modulus;
    model.poisson_ratio = poisson_ratio;
    model.density = density;
    model.restitution = restitution;
    model.sliding_friction = sliding_friction;
    return model;
}

std::string text(double x) {
    std::string digits = std::to_string(x);
    digits.erase(digits.find_last_not_of('0') + 1);
    if (digits.back() == '.') digits.pop_back();
    return digits;
}

// docs/physics.md section 5.5, Chung & Ooi test 4: column MD.
TEST(ObliqueWall, is_chung_and_ooi_test_4) {
    const ContactModel oxide = material(3.8e11, 0.23, 4000, 0.98, 0.092);
    for (const int angle : {5, 10, 15, 20, 25, 30, 40, 60, 80}) {
        const double radians = angle * std::numbers::pi / 180;
        const Impact impact{oxide, 2.5e-3, 3.9 * std::cos(radians), 2.5e-9 / std::pow(std::cos(radians), 0.2)};
        const auto found = impact.run(3.9 * std::sin(radians));
        const auto expected = [&](const char* what) { return reference("oxide." + std::to_string(angle) + what); };
        EXPECT_NEAR(found.tangential / (3.9 * std::sin(radians)), expected(".restitution"), 1e-3) << angle;
        EXPECT_NEAR(-found.spin / 2.5e-3 / expected(".spin"), -1, 2e-3) << angle;
        EXPECT_NEAR(std::atan(found.surface / found.normal) * 180 / std::numbers::pi, expected(".rebound"), 0.03)
            << angle;
        if (angle < 30) continue;
        // Sliding all the time: closed form.
        EXPECT_NEAR(found.tangential / (3.9 * std::sin(radians)), 1 - 0.092 * 1.98 / std::tan(radians), 1e-4);
    }
}

// Test 5: the same in units of mu v_n, where only the sliding branch agrees with the published curves.
TEST(ObliqueWall, is_chung_and_ooi_test_5) {
    const ContactModel steel = material(2.08e11, 0.3, 7850, 1, 0.3);
    const ContactModel polyethylene = material(1e9, 0.4, 1400, 1, 0.3);
    const double unit = 0.3 * 5;
    for (const double x : {0.6764, 1.0, 1.68, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0, 10.0, 13.0}) {
        const auto found = Impact{steel, 1e-5, 5, 2e-11}.run(x * unit);
        EXPECT_NEAR(found.surface / unit, reference("steel." + text(x) + ".recoil"), 5e-3) << x;
        EXPECT_NEAR(found.spin / unit, reference("steel." + text(x) + ".spin"), 5e-3) << x;
    }
    for (const double x : {6.5, 7.0, 10.0, 13.0}) {
        const auto found = Impact{polyethylene, 1e-5, 5, 1e-10}.run(x * unit);
        EXPECT_NEAR(found.surface / unit, x - 7, 5e-3) << x;
        EXPECT_NEAR(found.spin / unit, -5, 5e-3) << x;
    }
}

// Test 6: a spinning sphere meets a rigid wall straight on.
TEST(ObliqueWall, is_chung_and_ooi_test_6) {
    ContactModel alloy = material(7e10, 0.33, 2700, 0.5, 0.4), nylon = material(2.5e9, 0.4, 1000, 0.5, 0.4);
    alloy.wall_modulus = nylon.wall_modulus = WallModulus::rigid;
    for (const double psi : {0.26795, 0.57735, 1.0, 1.42815, 2.14451, 2.74748, 3.73205, 5.67128}) {
        const auto found = Impact{alloy, 0.1, 0.2, 5e-7}.run(0, 0.2 * psi);
        EXPECT_NEAR(found.surface / found.normal, reference("alloy." + text(psi) + ".recoil"), 3e-3) << psi;
        if (psi < 2.1) continue;
        const auto soft = Impact{nylon, 0.1, 0.2, 2e-6}.run(0, 0.2 * psi);
        EXPECT_NEAR(soft.surface / soft.normal, (psi - 2.1) / 0.5, 3e-3) << psi;
        EXPECT_NEAR(-soft.surface / (0.2 * psi), -(1 - 2.1 / psi), 3e-3) << psi;
    }
}

// Test 7: equal spheres with opposite spins meet straight on: the surfaces do not slide on each other.
TEST(OppositeSpins, are_kept_as_in_chung_and_ooi_test_7) {
    const ContactModel alloy = material(7e10, 0.33, 2700, 0.5, 0.4), copper = material(1.2e11, 0.35, 8900, 0.5, 0.4);
    for (const ContactModel& model : {alloy, copper})
        for (const double spin : {0.1, 1.0, 10.0}) {
            auto scene = testing::head_on_pair(model, 5e-7, 1e-6, 0.4, 0.2);
            scene.particles.angular_velocity = {{0, 0, spin}, {0, 0, -spin}};
            const ParticleTable after = testing::after_pair_impact(*scene.engine());
            EXPECT_NEAR(after.velocity[0].y, 0, 1e-14);
            EXPECT_NEAR(after.angular_velocity[0].z, spin, 1e-12);
            EXPECT_NEAR(after.angular_velocity[1].z, -spin, 1e-12);
            EXPECT_NEAR(after.velocity[1].x, 0.5 * 0.2, 1e-4);
        }
}

// The paper's powder on a wall: with the tangential dashpot and without.
TEST(ObliqueWall, of_the_powder_is_that_of_the_reference) {
    for (const bool damped : {true, false}) {
        ContactModel model = powder::model();
        model.tangential_damping = damped ? TangentialDamping::as_normal : TangentialDamping::none;
        model.rolling_friction = 0;
        const Impact impact{model, powder::radius, 0.05, 5e-9};
        const std::string kind = damped ? "powder.damped." : "powder.undamped.";
        for (const double x : {0.1, 0.3, 0.5, 1.0, 2.0}) {
            const auto found = impact.run(0.05 * x);
            EXPECT_NEAR(found.surface / 0.05, reference(kind + text(x) + ".recoil"), 1.5e-3) << kind << x;
            EXPECT_NEAR(found.tangential / 0.05 - x, reference(kind + text(x) + ".impulse"), 5e-4) << kind << x;
        }
    }
}

// Without attraction the rebound is the same at any stiffness ratio.
TEST(ObliqueWall, does_not_depend_on_the_stiffness) {
    for (const double ratio : {1.0, 0.01}) {
        ContactModel model = powder::model(ratio);
        model.rolling_friction = 0;
        const Impact impact{model, powder::radius, 0.05, 5e-9 * std::pow(ratio / 0.001, -0.4)};
        EXPECT_NEAR(impact.run(0.05).tangential / 0.05 - 1, reference("powder.damped.1.impulse"), 5e-4) << ratio;
    }
}

}  // namespace
}  // namespace recoat
