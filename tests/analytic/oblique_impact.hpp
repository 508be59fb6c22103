#pragma once

#include <cmath>
#include <string>

#include "tests/support/small_scene.hpp"

namespace recoat::testing {

/// After an oblique impact; in m/s, spin times radius, `surface` at the contact point.
struct Rebound {
    double normal = 0, tangential = 0, spin = 0;
    [[nodiscard]] double surface() const { return tangential + spin; }
};

/// An impact on the plane z = 0 and what it depends on; the arm is the radius, as in the closed forms.
struct ObliqueImpact {
    ContactModel model;
    double radius, normal_speed, time_step;

    /// `tangential` along x; `spin` times the radius adds to it at the contact point [m/s].
    [[nodiscard]] Rebound run(double tangential, double spin = 0) const {
        ContactModel used = model;
        used.lever_arm = LeverArm::radius;
        // Contact point below the centre: its velocity is v - w_y R along x.
        const auto scene = over_plane(used, time_step, 3.5 * normal_speed * time_step, {tangential, 0, -normal_speed},
                                      {0, -spin / radius, 0}, 2 * radius);
        const ParticleTable after = after_plane_impact(*scene.engine());
        return {after.velocity[0].z, after.velocity[0].x, -after.angular_velocity[0].y * radius};
    }
};

/// Duration of an elastic impact on a wall [s] [docs/physics.md section 4.1].
inline double elastic_duration(const ContactModel& model, double radius, double speed) {
    const double share = model.wall_modulus == WallModulus::rigid ? 1 : 0.5;
    const double modulus =
        share * plane_strain_modulus(model.stiffness_ratio * model.youngs_modulus, model.poisson_ratio);
    const double depth =
        std::pow(15 * sphere_mass(radius, model.density) * speed * speed / (16 * modulus * std::sqrt(radius)), 0.4);
    return 2.9432751843 * depth / speed;
}

inline ContactModel frictional(double youngs_modulus, double poisson_ratio, double density, double restitution,
                               double sliding_friction) {
    ContactModel model;
    model.youngs_modulus = youngs_modulus;
    model.poisson_ratio = poisson_ratio;
    model.density = density;
    model.restitution = restitution;
    model.sliding_friction = sliding_friction;
    return model;
}

/// A number as it stands in the names of the reference.
inline std::string shortest(double x) {
    std::string digits = std::to_string(x);
    digits.erase(digits.find_last_not_of('0') + 1);
    if (digits.back() == '.') digits.pop_back();
    return digits;
}

}  // namespace recoat::testing
