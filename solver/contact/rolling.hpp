#pragma once

#include <cmath>

#include "common/vec3.hpp"

namespace recoat {

/// Rolling resistance T = -mu_r L |F| w/|w| [paper eq. 3, corrected: docs/physics.md section 1.6].
struct Rolling {
    double friction;  ///< mu_r [-]

    /// The paper's own-spin form by implicit projection: `spin` after all other torques loses at most its length, so
    /// that a particle at rest stays at rest [docs/physics.md section 3]. `load` = sum of L |F| over the contacts [N
    /// m].
    RECOAT_HD Vec3 project(Vec3 spin, double load, double inertia, double time_step) const {
        const double size = std::sqrt(squared_norm(spin));
        const double loss = friction * load * time_step;
        const double held = inertia * size;
        const double factor = held > loss ? 1 - loss / held : 0;
        return factor * spin;
    }

    /// Torque on the first of a pair against their relative spin without its twist about the normal, limited to what
    /// stops it within the step. `inertia` is 1/(1/I_i + 1/I_j).
    RECOAT_HD Vec3 relative_torque(Vec3 relative_spin, Vec3 normal, double load, double inertia,
                                   double time_step) const {
        const Vec3 rolling = relative_spin - dot(relative_spin, normal) * normal;
        const double size = std::sqrt(squared_norm(rolling));
        const double wanted = friction * load;
        const double stop = inertia * size / time_step;
        const double torque = wanted < stop ? wanted : stop;
        return -(torque / (size > 1e-30 ? size : 1e-30)) * rolling;
    }
};

}  // namespace recoat
