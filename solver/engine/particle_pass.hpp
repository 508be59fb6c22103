#pragma once

#include "solver/contact/rolling.hpp"
#include "solver/engine/contacts.hpp"
#include "solver/engine/particles.hpp"

namespace recoat {

/// Which contacts a particle has, in the fixed order in which it adds them up.
struct IncidenceView {
    const std::size_t* begin;
    const std::int32_t* entry;
};

/// Sum of what a particle's contacts do to it.
template <bool equal_sizes, bool relative_rolling>
RECOAT_HD ContactForce gather(std::size_t i, IncidenceView incidence, const ContactForce* forces, const Row* rolling) {
    ContactForce sum;
    for (std::size_t e = incidence.begin[i]; e < incidence.begin[i + 1]; ++e) {
        const std::int32_t entry = incidence.entry[e];
        const ContactForce& contact = forces[entry >> 1];
        const bool second = entry & 1;
        const double sign = second ? -1 : 1;
        const double arm = !equal_sizes && second ? contact.arm_ratio() : 1;
        const double factor[8] = {sign, sign, sign, 1, arm, arm, arm, 0};
        for (int c = 0; c < 8; ++c) sum.value[c] += factor[c] * contact.value[c];
        if constexpr (relative_rolling) {
            const Row& torque = rolling[entry >> 1];
            sum.value[4] += sign * torque.x;
            sum.value[5] += sign * torque.y;
            sum.value[6] += sign * torque.z;
        }
    }
    return sum;
}

/// Adds up a particle's contact forces and advances its velocities; without attraction also its position.
/// Returns the squared speed, or infinity when it is not finite or above the limit: then the particle stays.
template <class Sizes, bool cohesive, bool relative_rolling>
struct ParticlePass {
    Sizes sizes;
    Rolling rolling;
    ParticleView p;
    IncidenceView incidence;
    const ContactForce* forces;
    const Row* rolling_torque;
    double* lost_rolling;  ///< [N] energy taken by own-spin rolling resistance [J]
    Vec3 gravity;
    double time_step;
    double own_rolling_length;    ///< times the radius, plus ...
    double own_rolling_constant;  ///< ... this, multiplies the load [-]
    double speed_limit_squared;

    RECOAT_HD double operator()(std::size_t i) const {
        const double radius = p.position[i].w;
        const ContactForce sum = gather<Sizes::equal, relative_rolling>(i, incidence, forces, rolling_torque);
        const Vec3 acceleration = sizes.inverse_mass_of(radius) * sum.force() + gravity;
        const Vec3 velocity = p.velocity[i].xyz() + time_step * acceleration;
        const double square = squared_norm(velocity);
        if (!(square < speed_limit_squared)) return __builtin_huge_val();

        turn(i, sum, radius);
        p.velocity[i].set(velocity);
        p.acceleration[i].set(acceleration);
        if constexpr (!cohesive) {
            p.position[i].set(p.position[i].xyz() + time_step * velocity);
            p.contact_velocity[i].set(velocity + 0.5 * time_step * acceleration);
        }
        return square;
    }

    /// Half a step back from the start: the velocities then are those of a leapfrog that was under way.
    RECOAT_HD void start(std::size_t i) const {
        const ContactForce sum = gather<Sizes::equal, relative_rolling>(i, incidence, forces, rolling_torque);
        const double radius = p.position[i].w;
        const Vec3 acceleration = sizes.inverse_mass_of(radius) * sum.force() + gravity;
        p.acceleration[i].set(acceleration);
        p.velocity[i].set(p.contact_velocity[i].xyz() - 0.5 * time_step * acceleration);
        p.spin[i].set(p.contact_spin[i].xyz() - (0.5 * time_step * sizes.inverse_inertia_of(radius)) * sum.torque());
    }

    /// Speed that the step would give [m/s].
    RECOAT_HD double next_speed(std::size_t i) const {
        const ContactForce sum = gather<Sizes::equal, relative_rolling>(i, incidence, forces, rolling_torque);
        const Vec3 acceleration = sizes.inverse_mass_of(p.position[i].w) * sum.force() + gravity;
        return norm(p.velocity[i].xyz() + time_step * acceleration);
    }

private:
    RECOAT_HD void turn(std::size_t i, const ContactForce& sum, double radius) const {
        const double inertia = sizes.inertia_of(radius);
        const Vec3 before = p.spin[i].xyz();
        Vec3 spin = before + (time_step * sizes.inverse_inertia_of(radius)) * sum.torque();
        if constexpr (!relative_rolling) {
            const double free = squared_norm(spin);
            const double load = (own_rolling_length * sizes.radius_of(radius) + own_rolling_constant) * sum.load();
            spin = rolling.project(spin, load, inertia, time_step);
            lost_rolling[i] += 0.5 * inertia * (free - squared_norm(spin));
        }
        p.spin[i].set(spin);
        p.contact_spin[i].set(spin + 0.5 * (spin - before));
    }
};

/// Adds the impulses of the attraction and moves the particle. Returns as ParticlePass.
///
/// With the discrete gradient the position moves by the mean of the velocities before and after the impulse, which
/// makes the work exact [docs/physics.md section 2.5]; the other schemes move by the one after it.
template <class Sizes>
struct ImpulsePass {
    Sizes sizes;
    ParticleView p;
    IncidenceView incidence;
    const Row* impulse;
    double time_step;
    double weight;  ///< of the velocity before the impulse: 1/2, or 0
    double speed_limit_squared;

    RECOAT_HD double operator()(std::size_t i) const {
        const Vec3 before = p.velocity[i].xyz();
        const Vec3 after = next_velocity(i);
        const Vec3 mean = weight * before + (1 - weight) * after;
        const double square = squared_norm(after);
        if (!(square < speed_limit_squared)) return __builtin_huge_val();
        p.velocity[i].set(after);
        p.position[i].set(p.position[i].xyz() + time_step * mean);
        p.contact_velocity[i].set(after + 0.5 * time_step * p.acceleration[i].xyz());
        return square > squared_norm(mean) ? square : squared_norm(mean);
    }

    RECOAT_HD Vec3 next_velocity(std::size_t i) const {
        Vec3 sum{};
        for (std::size_t e = incidence.begin[i]; e < incidence.begin[i + 1]; ++e) {
            const std::int32_t entry = incidence.entry[e];
            sum += (entry & 1 ? -1.0 : 1.0) * impulse[entry >> 1].xyz();
        }
        return p.velocity[i].xyz() + sizes.inverse_mass_of(p.position[i].w) * sum;
    }
};

}  // namespace recoat
