#pragma once

#include "solver/contact/impulse.hpp"
#include "solver/engine/contacts.hpp"
#include "solver/engine/partner.hpp"

namespace recoat {

/// Impulse of the attraction in contact `offset + k`, from the velocities that all other forces predict
/// [docs/physics.md section 2.5]. Returns 0.
template <class Partner, class Impulse>
struct AttractionPass {
    static constexpr bool measures = false;
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
        const Vec3 velocity = partner.velocity(p.velocity, j) - load(p.velocity, i).xyz();
        const double force = impulse(c.separation[k], dot(velocity, normal), partner.coefficients(p, i, j));
        const Vec3 push = time_step * force * normal;
        c.attraction[k] = force;
        store(c.impulse, k, row(push));
        if constexpr (Partner::is_wall) c.wall_work[k] += partner.wall_power(push);
        return 0;
    }
};

/// Sets the attraction of contact `offset + k` to the force at its separation: what the first step takes for that of
/// the step before it. Returns 0.
template <class Partner>
struct FirstAttractionPass {
    static constexpr bool measures = false;
    Partner partner;
    Attraction attraction;
    ParticleView p;
    ContactView c;
    std::size_t offset;

    RECOAT_HD double operator()(std::size_t index) const {
        const std::size_t k = offset + index;
        const std::int32_t i = c.first[k], j = c.second[k];
        c.attraction[k] = attraction.force(partner.meet(p, i, j).separation, partner.coefficients(p, i, j));
        return 0;
    }
};

}  // namespace recoat
