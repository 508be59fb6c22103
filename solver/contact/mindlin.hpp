#pragma once

#include <cmath>
#include <limits>

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
        using std::sqrt;
        const Vec3Of<T> flat = displacement - dot(displacement, normal) * normal;
        const T before = squared_norm(displacement), after = squared_norm(flat);
        // By the processor's own root and quotient, which work beside the products of the other roots.
        const T stretch = sqrt(before / larger(after, T(least_square)));
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
        const T stiffness = spring * inverse;
        // The sum is made in its place: g++ moves structs of packs by halves of registers.
        const Pull<T> pull{{-(stiffness * displacement.x) - viscous * sliding_velocity.x,
                            -(stiffness * displacement.y) - viscous * sliding_velocity.y,
                            -(stiffness * displacement.z) - viscous * sliding_velocity.z},
                           limit};
        displacement = select((normal_force > T(0)) & sliding, longest * inverse, T(1)) * displacement;
        return pull;
    }

    /// The part of a pull that friction can bear [N].
    template <class T>
    RECOAT_HD Vec3Of<T> borne(Vec3Of<T> sum, T limit) const {
        const T strength = squared_norm(sum);
        // Where it slides, spring and limit differ by round-off alone.
        const auto beyond = (T(cap) > T(0)) & (strength > T(Real(1) + 8 * round_off) * (limit * limit));
        T share = T(1);
        if (any(beyond)) share = select(beyond, limit * inverse_root(strength), T(1));
        return {share * sum.x, share * sum.y, share * sum.z};
    }

    /// Force on the first partner; as pull() and borne().
    template <class T>
    RECOAT_HD Vec3Of<T> force(Vec3Of<T>& displacement, T normal_force, T overlap, T inverse_overlap, T dashpot,
                              const KinematicsOf<T>& k) const {
        const Pull<T> pull =
            this->pull(displacement, normal_force, overlap, inverse_overlap, dashpot, k.sliding_velocity);
        return borne(pull.sum, pull.limit);
    }

    /// Energy that the spring would give back at constant normal force [J].
    RECOAT_HD double energy(Vec3 displacement, double normal_force, double overlap) const {
        const double longest = slip_per_overlap * overlap;
        const double share = longest > 0 ? norm(displacement) / longest : 0;
        const double rest = share < 1 ? 1 - share : 0;
        return friction * normal_force * longest *
               ((share < 1 ? share : 1) - 0.4 * (1 - rest * rest * std::sqrt(rest)));
    }

    static constexpr Real round_off = std::numeric_limits<Real>::epsilon();
    /// Square of a displacement that stands for none, far below any that matters and above the least number [m2].
    static constexpr Real least_square = sizeof(Real) == 8 ? 1e-80 : 1e-36;
};

using Mindlin = MindlinOf<double>;

}  // namespace recoat
