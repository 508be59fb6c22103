#pragma once

#include "common/vec3.hpp"

namespace recoat {

/// Relative motion of one contact; the first partner is a particle, the second a particle or a wall.
template <class T>
struct KinematicsOf {
    Vec3Of<T> normal;  ///< unit vector from the first to the second
    T separation;      ///< s [m]; negative: overlap
    T closing_rate;    ///< ds/dt [m/s]
    Vec3Of<T>
        sliding_velocity;  ///< of the first relative to the second at the contact point, in the tangent plane [m/s]
};

using Kinematics = KinematicsOf<double>;

/// Assembles the relative motion [docs/physics.md sections 1.3, 1.5].
///
/// `velocity` is that of the first relative to the second at the centres, `arm_spin` = a_i w_i + a_j w_j.
template <class T>
RECOAT_HD KinematicsOf<T> kinematics(Vec3Of<T> normal, T separation, Vec3Of<T> velocity, Vec3Of<T> arm_spin) {
    const Vec3Of<T> surface = velocity + cross(arm_spin, normal);
    const T along = dot(velocity, normal);
    return {normal, separation, -along, surface - along * normal};
}

}  // namespace recoat
