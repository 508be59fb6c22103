#pragma once

#include "solver/contact/impulse.hpp"
#include "solver/engine/contacts.hpp"
#include "solver/engine/partner.hpp"

namespace recoat {

/// Impulse of the attraction in contact `offset + k`, from the velocities that all other forces predict
/// [docs/physics.md section 2.5]; or, `again`, from those that the impulses found so far foresee (ForeseePass).
/// Returns 0.
template <class Partner, class Impulse, bool again>
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
        const Row* velocities = again ? p.contact_velocity : p.velocity;
        const Vec3 velocity = partner.velocity(velocities, j) - load(velocities, i).xyz();
        const Coefficients& coefficients = partner.coefficients(p, i, j);
        const double before = again ? c.attraction[k] : 0;
        const double rate = rate_without(before, dot(velocity, normal), coefficients, time_step);
        const double force = impulse(c.separation[k], rate, coefficients);
        c.attraction[k] = force;
        store(c.impulse, k, row(time_step * force * normal));
        if constexpr (Partner::is_wall) c.wall_work[k] += partner.wall_power(time_step * (force - before) * normal);
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
