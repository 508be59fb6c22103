#pragma once

#include <cmath>

#include "common/select.hpp"
#include "solver/contact/coefficients.hpp"

namespace recoat {

/// Hertzian repulsion with viscous damping [paper eq. 4; docs/physics.md section 1.3].
///
///   F_e = 4/3 E* sqrt(R*) d^(3/2),   F_d = 2 sqrt(5/6) beta sqrt(S_n m*) u,   S_n = 2 E* sqrt(R* d)      [N]
template <class Real>
struct HertzOf {
    Real clip;  ///< 1: forbid an attractive sum, 0: allow it (a number, so that loops stay vectors)

    template <class T, class C>
    RECOAT_HD T elastic(T overlap, T root, const C& c) const {
        return c.hertz * overlap * root;
    }

    /// Viscous part of the repulsion; `rate` = ds/dt, `quarter` = overlap^(1/4).
    template <class T, class C>
    RECOAT_HD T viscous(T elastic, T quarter, T rate, const C& c) const {
        const T force = -(c.normal_damping * quarter * rate);
        return select(T(clip) > T(0), larger(force, -elastic), force);
    }

    /// Stored energy 2/5 k_H d^(5/2) [J].
    template <class C>
    RECOAT_HD double energy(double overlap, const C& c) const {
        return 0.4 * c.hertz * overlap * overlap * std::sqrt(overlap);
    }
};

using Hertz = HertzOf<double>;

}  // namespace recoat
