#pragma once

#include "common/vec3.hpp"

namespace recoat {

/// Relative motion of one contact; the first partner is a particle, the second a particle or a wall.
struct Kinematics {
    Vec3 normal;            ///< unit vector from the first to the second
    double separation;      ///< s [m]; negative: overlap
    double closing_rate;    ///< ds/dt [m/s]
    Vec3 sliding_velocity;  ///< of the first relative to the second at the contact point, in the tangent plane [m/s]
};

/// Assembles the relative motion [docs/physics.md sections 1.3, 1.5].
///
/// `velocity` is that of the first relative to the second at the centres, `arm_spin` = a_i w_i + a_j w_j.
RECOAT_HD Kinematics kinematics(Vec3 normal, double separation, Vec3 velocity, Vec3 arm_spin) {
    const Vec3 surface = velocity + cross(arm_spin, normal);
    const double along = dot(velocity, normal);
    return {normal, separation, -along, surface - along * normal};
}

}  // namespace recoat
