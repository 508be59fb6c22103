#pragma once

#include "solver/contact/impulse.hpp"
#include "solver/engine/partner.hpp"

namespace recoat {

/// Impulse of the attraction in contact `offset + k`, from the velocities that all other forces predict
/// [docs/physics.md section 2.5]. Returns 0.
template <class Partner, class Impulse>
struct AttractionPass {
    Partner partner;
    Impulse impulse;
    ParticleView p;
    ContactView c;
    double time_step;  ///< [s]
    std::size_t offset;

    RECOAT_HD double operator()(std::size_t index) const {
        const std::size_t k = offset + index;
        const std::int32_t i = c.first[k], j = c.second[k];
        const Vec3 normal = {c.normal_x[k], c.normal_y[k], c.normal_z[k]};
        const Vec3 velocity = partner.velocity(p.velocity, j) - p.velocity[i].xyz();
        const double force = impulse(c.separation[k], dot(velocity, normal), partner.coefficients(p, i, j));
        const Vec3 push = time_step * force * normal;
        c.attraction[k] = force;
        c.impulse[k].set(push);
        if constexpr (Partner::is_wall) c.wall_work[k] += partner.wall_power(push);
        return 0;
    }
};

}  // namespace recoat
