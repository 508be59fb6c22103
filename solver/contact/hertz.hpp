#pragma once

#include "common/host_device.hpp"
#include "solver/contact/coefficients.hpp"

namespace recoat {

/// Hertzian repulsion with viscous damping [paper eq. 4; docs/physics.md section 1.3].
///
///   F_e = 4/3 E* sqrt(R*) d^(3/2),   F_d = 2 sqrt(5/6) beta sqrt(S_n m*) u,   S_n = 2 E* sqrt(R* d)      [N]
struct Hertz {
    double clip;  ///< 1: forbid an attractive sum, 0: allow it (a number, so that loops stay vectors)

    RECOAT_HD double elastic(double overlap, double root, const Coefficients& c) const {
        return c.hertz * overlap * root;
    }

    /// Viscous part of the repulsion; `rate` = ds/dt, `quarter` = overlap^(1/4).
    RECOAT_HD double viscous(double elastic, double quarter, double rate, const Coefficients& c) const {
        const double force = -c.normal_damping * quarter * rate;
        const double least = clip > 0 ? -elastic : -1e300;
        return force < least ? least : force;
    }

    /// Stored energy 2/5 k_H d^(5/2) [J].
    RECOAT_HD double energy(double overlap, const Coefficients& c) const {
        return 0.4 * c.hertz * overlap * overlap * std::sqrt(overlap);
    }
};

}  // namespace recoat
