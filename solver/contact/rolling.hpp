#pragma once

#include <cmath>

#include "common/select.hpp"
#include "common/vec3.hpp"
#include "solver/contact/roots.hpp"

namespace recoat {

/// Rolling resistance T = -mu_r L |F| w/|w| [paper eq. 3, corrected: docs/physics.md section 1.6].
template <class Real>
struct RollingOf {
    Real friction;  ///< mu_r [-]

    /// The paper's own-spin form by implicit projection: a spin of `square` = |w|^2 after all other torques keeps this
    /// share of itself, so that a particle at rest stays at rest [docs/physics.md section 3]. `load` = sum of L |F|
    /// over the contacts [N m].
    template <class T>
    RECOAT_HD T kept(T square, T load, T inverse_inertia, T time_step) const {
        const T share = friction * (load * time_step) * (inverse_inertia * inverse_root(square));
        return larger(T(1) - share, T(0));
    }

    RECOAT_HD Vec3 project(Vec3 spin, double load, double inertia, double time_step) const {
        return kept(squared_norm(spin), load, 1 / inertia, time_step) * spin;
    }

    /// Torque on the first of a pair against their relative spin without its twist about the normal, limited to what
    /// stops it within the step. `inertia` is 1/(1/I_i + 1/I_j).
    template <class T>
    RECOAT_HD Vec3Of<T> relative_torque(Vec3Of<T> relative_spin, Vec3Of<T> normal, T load, T inertia,
                                        T time_step) const {
        const Vec3Of<T> rolling = relative_spin - dot(relative_spin, normal) * normal;
        const T square = squared_norm(rolling);
        const T inverse = inverse_root(larger(square, T(least_square)));
        const T stop = inertia * (square * inverse) / time_step;
        return -((smaller(friction * load, stop) * inverse) * rolling);
    }

    static constexpr Real least_square = sizeof(Real) == 8 ? 1e-60 : 1e-30;  ///< of a spin that is none [1/s2]
};

using Rolling = RollingOf<double>;

}  // namespace recoat
