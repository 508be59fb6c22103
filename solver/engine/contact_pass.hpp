#pragma once

#include "solver/contact/law.hpp"
#include "solver/engine/partner.hpp"

namespace recoat {

/// Contact forces of contact `offset + k`; returns its overlap [m].
template <class Partner, bool cohesive, bool relative_rolling>
struct ContactPass {
    Partner partner;
    ContactLaw<cohesive> law;
    ParticleView p;
    ContactView c;
    double time_step;  ///< [s]
    double ageing;     ///< time by which history grows: the step, or 0 to evaluate forces only [s]
    std::size_t offset;

    RECOAT_HD double operator()(std::size_t index) const {
        const std::size_t k = offset + index;
        const std::int32_t i = c.first[k], j = c.second[k];
        const Meeting meeting = partner.meet(p, i, j);
        const Coefficients& coefficients = partner.coefficients(p, i, j);
        const double first_arm = partner.first_arm(p, i, j, meeting.distance);
        const double second_arm = partner.second_arm(p, j, meeting.distance, first_arm);
        const Vec3 first_spin = p.contact_spin[i].xyz(), second_spin = partner.spin(p, j);
        const Vec3 velocity = p.contact_velocity[i].xyz() - partner.velocity(p.contact_velocity, j);
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

        const double load = coefficients.rolling_length * result.friction_load;
        c.force[k] = ContactForce(result.force, load, first_arm * cross(meeting.normal, result.tangential),
                                  Partner::equal ? 1 : second_arm / first_arm);
        if constexpr (relative_rolling) {
            const double inertia = partner.rolling_inertia(p, i, j);
            const Vec3 torque =
                law.rolling.relative_torque(first_spin - second_spin, meeting.normal, load, inertia, time_step);
            c.rolling[k].set(torque);
            c.rolling[k].w -= ageing * dot(torque, first_spin - second_spin);
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
