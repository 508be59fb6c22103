#pragma once

#include <cmath>

#include "common/select.hpp"
#include "solver/contact/kinematics.hpp"
#include "solver/contact/roots.hpp"

namespace recoat {

/// Mindlin-Deresiewicz friction in total-displacement form [paper eq. 5; docs/physics.md section 1.5].
///
///   |d_t| < d_max:  F_t = -mu F [1 - (1 - |d_t|/d_max)^(3/2)] d_t/|d_t| - 2 sqrt(5/6) beta_t sqrt(S_t m*) v_t
///   otherwise:      F_t = -mu F d_t/|d_t|,          d_max = mu d (2-nu)/(2-2nu)                           [N]
template <class Real>
struct MindlinOf {
    Real friction;          ///< mu_t [-]
    Real slip_per_overlap;  ///< mu_t (2-nu)/(2-2nu) [-]
    Real cap;               ///< 1: limit spring plus dashpot to mu F, 0: do not

    /// Turns the stored displacement into the tangent plane at its old length [Luding 2008], adds the sliding of
    /// `time_step`.
    template <class T>
    RECOAT_HD Vec3Of<T> advance(Vec3Of<T> displacement, const KinematicsOf<T>& k, T time_step) const {
        return advance(displacement, k.normal, k.sliding_velocity, time_step);
    }
    template <class T>
    RECOAT_HD Vec3Of<T> advance(Vec3Of<T> displacement, Vec3Of<T> normal, Vec3Of<T> sliding_velocity,
                                T time_step) const {
        const Vec3Of<T> flat = displacement - dot(displacement, normal) * normal;
        const T before = squared_norm(displacement), after = squared_norm(flat);
        // sqrt(before/after), by factors that single precision can hold
        const T stretch = (before * inverse_root(before)) * inverse_root(after);
        return select(after > T(least_square), stretch, T(1)) * flat + time_step * sliding_velocity;
    }

    /// What the spring and the dashpot ask for, and what friction allows.
    template <class T>
    struct Pull {
        Vec3Of<T> sum;  ///< on the first partner [N]
        T limit;        ///< mu F [N]
    };

    /// Spring and dashpot; shortens `displacement` to d_max when it slides.
    ///
    /// `normal_force` F [N] and `overlap` d [m] are the equivalent ones of docs/physics.md section 2.2 (c),
    /// `inverse_overlap` is 1/d, anything where d = 0 [1/m]; `dashpot` [kg/s]. With F = 0 there is no force, and the
    /// displacement is kept.
    template <class T>
    RECOAT_HD Pull<T> pull(Vec3Of<T>& displacement, T normal_force, T overlap, T inverse_overlap, T dashpot,
                           Vec3Of<T> sliding_velocity) const {
        const T longest = slip_per_overlap * overlap;
        const T square = larger(squared_norm(displacement), T(least_square));
        const T inverse = inverse_root(square);
        const T length = square * inverse;
        const auto sliding = length >= longest;
        const T share = select(sliding, T(1), length * (inverse_overlap * T(1 / slip_per_overlap)));
        const T rest = T(1) - share;
        const T limit = friction * normal_force;
        const T spring = limit * (T(1) - rest * (rest * inverse_root(rest)));
        const T viscous = select(sliding, T(0), dashpot);
        const Vec3Of<T> sum = -((spring * inverse) * displacement) - viscous * sliding_velocity;
        displacement = select((normal_force > T(0)) & sliding, longest * inverse, T(1)) * displacement;
        return {sum, limit};
    }

    /// The part of a pull that friction can bear [N].
    template <class T>
    RECOAT_HD Vec3Of<T> borne(const Pull<T>& pull) const {
        const T strength = squared_norm(pull.sum);
        const auto beyond = (T(cap) > T(0)) & (strength > pull.limit * pull.limit);
        return select(beyond, pull.limit * inverse_root(strength), T(1)) * pull.sum;
    }

    /// Force on the first partner; as pull() and borne().
    template <class T>
    RECOAT_HD Vec3Of<T> force(Vec3Of<T>& displacement, T normal_force, T overlap, T inverse_overlap, T dashpot,
                              const KinematicsOf<T>& k) const {
        return borne(pull(displacement, normal_force, overlap, inverse_overlap, dashpot, k.sliding_velocity));
    }

    /// Energy that the spring would give back at constant normal force [J].
    RECOAT_HD double energy(Vec3 displacement, double normal_force, double overlap) const {
        const double longest = slip_per_overlap * overlap;
        const double share = longest > 0 ? norm(displacement) / longest : 0;
        const double rest = share < 1 ? 1 - share : 0;
        return friction * normal_force * longest *
               ((share < 1 ? share : 1) - 0.4 * (1 - rest * rest * std::sqrt(rest)));
    }

    /// Square of a displacement that stands for none, far below any that matters and above the least number [m2].
    static constexpr Real least_square = sizeof(Real) == 8 ? 1e-80 : 1e-36;
};

using Mindlin = MindlinOf<double>;

}  // namespace recoat
