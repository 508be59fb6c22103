#pragma once

#include "solver/contact/law.hpp"
#include "solver/engine/contacts.hpp"
#include "solver/engine/partner.hpp"

namespace recoat {

/// Contact forces of contact `offset + k`; returns its overlap [m].
template <class Partner, bool cohesive, bool relative_rolling>
struct ContactPass {
    static constexpr bool measures = true;
    Partner partner;
    ContactLaw<cohesive> law;
    ParticleView p;
    ContactView c;
    double time_step;  ///< [s]
    double ageing;     ///< time by which history grows: the step, or 0 to evaluate forces only [s]
    std::size_t offset;
    const std::int32_t* incidence_begin;  ///< [N + 1], for relative rolling

    RECOAT_HD double operator()(std::size_t index) const {
        const std::size_t k = offset + index;
        const std::int32_t i = c.first[k], j = c.second[k];
        const Meeting meeting = partner.meet(p, i, j);
        const Coefficients& coefficients = partner.coefficients(p, i, j);
        const double first_arm = partner.first_arm(p, i, j, meeting.distance);
        const double second_arm = partner.second_arm(p, j, meeting.distance, first_arm);
        const Vec3 first_spin = load(p.contact_spin, i).xyz(), second_spin = partner.spin(p, j);
        const Vec3 velocity = load(p.contact_velocity, i).xyz() - partner.velocity(p.contact_velocity, j);
        const Kinematics motion =
            kinematics(meeting.normal, meeting.separation, velocity, first_arm * first_spin + second_arm * second_spin);

        Vec3 slip = {c.slip_x[k], c.slip_y[k], c.slip_z[k]};
        const ContactResult result = law(motion, coefficients, cohesive ? c.attraction[k] : 0.0, ageing, slip);
        c.slip_x[k] = slip.x;
        c.slip_y[k] = slip.y;
        c.slip_z[k] = slip.z;
        c.lost_normal[k] += ageing * result.normal_power;
        c.lost_tangential[k] += ageing * result.tangential_power;
        if constexpr (Partner::is_wall) c.wall_work[k] += ageing * partner.wall_power(result.force);

        const double friction = coefficients.rolling_length * result.friction_load;
        store(c.force, k,
              ContactForce(result.force, friction, first_arm * cross(meeting.normal, result.tangential),
                           Partner::equal ? 1 : second_arm / first_arm));
        if constexpr (relative_rolling) {
            // Each of a particle's contacts may take its share of what stops it, of the spin that the torque changes.
            const double share = 1.0 / partner.busiest(incidence_begin, i, j);
            const Vec3 spin = load(p.spin, i).xyz() - partner.lagging_spin(p, j);
            const double inertia = share * partner.rolling_inertia(p, i, j);
            store(c.rolling, k, row(law.rolling.relative_torque(spin, meeting.normal, friction, inertia, time_step)));
        }
        if constexpr (cohesive) {
            c.normal_x[k] = meeting.normal.x;
            c.normal_y[k] = meeting.normal.y;
            c.normal_z[k] = meeting.normal.z;
            c.separation[k] = meeting.separation;
        }
        return -meeting.separation;
    }
};

}  // namespace recoat
