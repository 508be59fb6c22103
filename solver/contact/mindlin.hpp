#pragma once

#include <cmath>

#include "common/vec3.hpp"
#include "solver/contact/kinematics.hpp"

namespace recoat {

/// Mindlin-Deresiewicz friction in total-displacement form [paper eq. 5; docs/physics.md section 1.5].
///
///   |d_t| < d_max:  F_t = -mu F [1 - (1 - |d_t|/d_max)^(3/2)] d_t/|d_t| - 2 sqrt(5/6) beta_t sqrt(S_t m*) v_t
///   otherwise:      F_t = -mu F d_t/|d_t|,          d_max = mu d (2-nu)/(2-2nu)                           [N]
struct Mindlin {
    double friction;          ///< mu_t [-]
    double slip_per_overlap;  ///< mu_t (2-nu)/(2-2nu) [-]
    double cap;               ///< 1: limit spring plus dashpot to mu F, 0: do not

    /// Turns the stored displacement into the tangent plane at its old length [Luding 2008], adds the sliding of
    /// `time_step`.
    RECOAT_HD Vec3 advance(Vec3 displacement, const Kinematics& k, double time_step) const {
        const Vec3 flat = displacement - dot(displacement, k.normal) * k.normal;
        const double before = squared_norm(displacement), after = squared_norm(flat);
        const double stretch = std::sqrt((after > 0 ? before : 1) / (after > 0 ? after : 1));
        return stretch * flat + time_step * k.sliding_velocity;
    }

    /// Force on the first partner; shortens `displacement` to d_max when it slides.
    ///
    /// `normal_force` F [N] and `overlap` d [m] are the equivalent ones of docs/physics.md section 2.2 (c); `dashpot`
    /// [kg/s]. With F = 0 there is no force, and the displacement is kept.
    RECOAT_HD Vec3 force(Vec3& displacement, double normal_force, double overlap, double dashpot,
                         const Kinematics& k) const {
        const double longest = slip_per_overlap * overlap;
        const double length = std::sqrt(squared_norm(displacement));
        const bool sliding = length >= longest;
        const double inverse = 1 / (length > smallest ? length : smallest);
        const double share = sliding ? 1 : length / (longest > smallest ? longest : smallest);
        const double rest = 1 - share;
        const double limit = friction * normal_force;
        const double spring = limit * (1 - rest * std::sqrt(rest));
        const double viscous = sliding ? 0 : dashpot;
        const Vec3 sum = -(spring * inverse) * displacement - viscous * k.sliding_velocity;
        const double square = squared_norm(sum);
        const double most = cap > 0 ? limit * limit : 1e300;
        const double factor = (square > most ? limit : 1) / std::sqrt(square > most ? square : 1);
        displacement = (length >= (normal_force > 0 ? longest : 1e300) ? longest * inverse : 1) * displacement;
        return factor * sum;
    }

    /// Energy that the spring would give back at constant normal force [J].
    RECOAT_HD double energy(Vec3 displacement, double normal_force, double overlap) const {
        const double longest = slip_per_overlap * overlap;
        const double share = longest > smallest ? norm(displacement) / longest : 0;
        const double rest = share < 1 ? 1 - share : 0;
        return friction * normal_force * longest *
               ((share < 1 ? share : 1) - 0.4 * (1 - rest * rest * std::sqrt(rest)));
    }

    static constexpr double smallest = 1e-40;  ///< [m]; keeps a division finite, far below any displacement
};

}  // namespace recoat
