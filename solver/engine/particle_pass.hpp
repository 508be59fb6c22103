#pragma once

#include "solver/contact/rolling.hpp"
#include "solver/engine/contacts.hpp"
#include "solver/engine/particles.hpp"

namespace recoat {

/// Which contacts a particle has, in the fixed order in which it adds them up.
struct IncidenceView {
    const std::int32_t* begin;
    const std::int32_t* entry;
};

/// Sum of what a particle's contacts do to it.
struct Gathered {
    ContactForce sum;
    Vec3 rolling;  ///< torque of relative rolling resistance, not in the sum [N m]

    RECOAT_HD Vec3 torque() const { return sum.torque() + rolling; }
};

template <bool equal_sizes, bool relative_rolling>
RECOAT_HD Gathered gather(std::size_t i, IncidenceView incidence, const ContactForce* forces, const Row* rolling) {
    Gathered found;
    for (std::int32_t e = incidence.begin[i], end = incidence.begin[i + 1]; e < end; ++e) {
        const std::int32_t entry = incidence.entry[e];
        const ContactForce contact = load(forces, entry >> 1);
        const bool second = entry & 1;
        const double sign = second ? -1 : 1;
        const double arm = !equal_sizes && second ? contact.arm_ratio() : 1;
        const double factor[8] = {sign, sign, sign, 1, arm, arm, arm, 0};
        for (int c = 0; c < 8; ++c) found.sum.value[c] += factor[c] * contact.value[c];
        if constexpr (relative_rolling) found.rolling += sign * load(rolling, entry >> 1).xyz();
    }
    return found;
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
    double* lost_rolling;  ///< [N] energy taken by rolling resistance [J]
    Vec3 gravity;
    double time_step;
    double own_rolling_length;    ///< times the radius, plus ...
    double own_rolling_constant;  ///< ... this, multiplies the load [-]
    double speed_limit_squared;

    RECOAT_HD double operator()(std::size_t i) const {
        const Row position = load(p.position, i);
        const Gathered got = gather<Sizes::equal, relative_rolling>(i, incidence, forces, rolling_torque);
        const Vec3 acceleration = sizes.inverse_mass_of(position.w) * got.sum.force() + gravity;
        const Vec3 velocity = load(p.velocity, i).xyz() + time_step * acceleration;
        const double square = squared_norm(velocity);
        if (!(square < speed_limit_squared)) return __builtin_huge_val();

        turn(i, got, position.w);
        store(p.velocity, i, row(velocity));
        if constexpr (cohesive) {
            store(p.acceleration, i, row(acceleration));
        } else {
            store(p.position, i, row(position.xyz() + time_step * velocity, position.w));
            store(p.contact_velocity, i, row(velocity + 0.5 * time_step * acceleration));
        }
        return square;
    }

    /// Half a step back from the start: the velocities then are those of a leapfrog that was under way.
    /// Rolling resistance, which may stop a spin within a step, is left out.
    RECOAT_HD void start(std::size_t i) const {
        const Gathered got = gather<Sizes::equal, relative_rolling>(i, incidence, forces, rolling_torque);
        const double radius = load(p.position, i).w;
        const Vec3 acceleration = sizes.inverse_mass_of(radius) * got.sum.force() + gravity;
        const Vec3 turning = sizes.inverse_inertia_of(radius) * got.sum.torque();
        store(p.acceleration, i, row(acceleration));
        store(p.velocity, i, row(load(p.contact_velocity, i).xyz() - 0.5 * time_step * acceleration));
        store(p.spin, i, row(load(p.contact_spin, i).xyz() - 0.5 * time_step * turning));
    }

    /// Speed that the step would give [m/s].
    RECOAT_HD double next_speed(std::size_t i) const {
        const Gathered got = gather<Sizes::equal, relative_rolling>(i, incidence, forces, rolling_torque);
        const Vec3 acceleration = sizes.inverse_mass_of(load(p.position, i).w) * got.sum.force() + gravity;
        return norm(load(p.velocity, i).xyz() + time_step * acceleration);
    }

private:
    /// Rolling resistance takes its torque times the mean of the spins before and after: energy is then booked exactly,
    /// and nothing is when nothing turns.
    RECOAT_HD void turn(std::size_t i, const Gathered& got, double radius) const {
        const double inertia = sizes.inertia_of(radius);
        const Vec3 before = load(p.spin, i).xyz();
        Vec3 spin = before + (time_step * sizes.inverse_inertia_of(radius)) * got.torque();
        if constexpr (relative_rolling) {
            lost_rolling[i] -= 0.5 * time_step * dot(got.rolling, before + spin);
        } else {
            const Vec3 free = spin;
            const double load = (own_rolling_length * sizes.radius_of(radius) + own_rolling_constant) * got.sum.load();
            spin = rolling.project(spin, load, inertia, time_step);
            lost_rolling[i] += 0.5 * inertia * dot(free - spin, before + spin);
        }
        store(p.spin, i, row(spin));
        store(p.contact_spin, i, row(spin + 0.5 * (spin - before)));
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
        const Row position = load(p.position, i);
        const Vec3 before = load(p.velocity, i).xyz();
        const Vec3 after = pushed(i, before, position.w);
        const Vec3 mean = weight * before + (1 - weight) * after;
        const double square = squared_norm(after);
        if (!(square < speed_limit_squared)) return __builtin_huge_val();
        store(p.velocity, i, row(after));
        store(p.position, i, row(position.xyz() + time_step * mean, position.w));
        store(p.contact_velocity, i, row(after + 0.5 * time_step * load(p.acceleration, i).xyz()));
        return square > squared_norm(mean) ? square : squared_norm(mean);
    }

    /// Mean velocity of the step by the impulses found so far [m/s].
    RECOAT_HD Vec3 mean(std::size_t i) const {
        const Vec3 before = load(p.velocity, i).xyz();
        return weight * before + (1 - weight) * pushed(i, before, load(p.position, i).w);
    }

    /// Speed that the step would give [m/s].
    RECOAT_HD double next_speed(std::size_t i) const {
        return norm(pushed(i, load(p.velocity, i).xyz(), load(p.position, i).w));
    }

private:
    RECOAT_HD Vec3 pushed(std::size_t i, Vec3 velocity, double radius) const {
        Vec3 sum{};
        for (std::int32_t e = incidence.begin[i], end = incidence.begin[i + 1]; e < end; ++e) {
            const std::int32_t entry = incidence.entry[e];
            sum += (entry & 1 ? -1.0 : 1.0) * load(impulse, entry >> 1).xyz();
        }
        return velocity + sizes.inverse_mass_of(radius) * sum;
    }
};

/// Writes the mean velocity of the step by the impulses found so far in the place of the one that contacts see. Returns
/// 0.
template <class Sizes>
struct ForeseePass {
    ImpulsePass<Sizes> motion;

    RECOAT_HD double operator()(std::size_t i) const {
        store(motion.p.contact_velocity, i, row(motion.mean(i)));
        return 0;
    }
};

}  // namespace recoat
