#pragma once

#include "solver/engine/far_list.hpp"
#include "solver/engine/sleep_rule.hpp"
#include "solver/engine/snapshot.hpp"

namespace recoat {

// Who is quiet; loops stand by themselves because a device compiler takes their bodies only from functions that
// everybody may call.

/// Whether a particle has stayed where it is for long enough.
struct Quiet {
    const Row* rest;  ///< as ParticleArrays::rest
    double before;    ///< last step since which that is long enough

    template <class Space>
    Quiet(const SnapshotOf<Space>& s, const SleepRule& rule)
        : rest(s.rest.data()), before(static_cast<double>(s.step - rule.rest)) {}

    RECOAT_HD bool operator()(std::size_t i) const { return rest[i].w <= before; }
};

/// Takes note of the awake particles that have left their place or turned.
template <class Space>
void note_motion(Space& space, SnapshotOf<Space>& s, const SleepRule& rule, Period period) {
    const Row *position = s.particles.position.data(), *spin = s.particles.spin.data();
    Row* rest = s.rest.data();
    const Quiet quiet(s, rule);
    const double reach = rule.reach * rule.reach, turn = rule.turn * rule.turn, now = static_cast<double>(s.step);
    space.for_each(s.awake, [=] RECOAT_LAMBDA(std::size_t i) {
        const Row p = load(position, i);
        const double way = squared_norm(period.nearest(p.xyz() - rest[i].xyz()));
        const double surface = p.w * p.w * squared_norm(spin[i].xyz());
        const double patience = quiet(i) ? SleepRule::patience * SleepRule::patience : 1;
        // Compared this way, not-a-number is motion.
        if (!(way < patience * reach) || !(surface < patience * turn)) rest[i] = row(p.xyz(), now);
    });
}

/// Takes it that all particles have just moved.
template <class Space>
void rouse(Space& space, SnapshotOf<Space>& s) {
    const Row* position = s.particles.position.data();
    Row* rest = s.rest.data();
    const double now = static_cast<double>(s.step);
    space.for_each(s.particles.size(), [=] RECOAT_LAMBDA(std::size_t i) { rest[i] = row(position[i].xyz(), now); });
}

/// Number of quiet particles among the awake.
template <class Space>
double count_quiet(Space& space, const SnapshotOf<Space>& s, const Quiet& quiet) {
    return space.sum(s.awake, [=] RECOAT_LAMBDA(std::size_t i) { return quiet(i) ? 1.0 : 0.0; });
}

/// Whether what moves has come to within two contacts of a sleeper: one of a pair of the close list of the particle is
/// not quiet, and one of it has a sleeper there, or is one. A push takes its time to pass on to the next particle, so
/// that sleepers that are woken now have not felt it.
struct DisturbedGuard {
    Quiet quiet;
    const std::int32_t *offsets, *second;
    std::int32_t awake;

    template <class Space>
    DisturbedGuard(const SnapshotOf<Space>& s, const Quiet& who)
        : quiet(who),
          offsets(s.contacts.offsets.data()),
          second(s.contacts.second.data()),
          awake(static_cast<std::int32_t>(s.awake)) {}

    RECOAT_HD bool operator()(std::size_t i) const {
        if (i >= static_cast<std::size_t>(awake)) return false;
        const bool moves = !quiet(i), beside = beside_sleeper(i);
        if (moves && beside) return true;
        for (std::int32_t k = offsets[i]; k < offsets[i + 1] && second[k] < awake; ++k) {
            const auto j = static_cast<std::size_t>(second[k]);
            if ((moves && beside_sleeper(j)) || (beside && !quiet(j))) return true;
        }
        return false;
    }

private:
    /// Partners ascend, and sleepers come last.
    RECOAT_HD bool beside_sleeper(std::size_t i) const {
        const std::int32_t end = offsets[i + 1];
        return end > offsets[i] && second[end - 1] >= awake;
    }
};

template <class Space>
bool sleepers_disturbed(Space& space, const SnapshotOf<Space>& s, const Quiet& quiet) {
    const DisturbedGuard disturbed(s, quiet);
    return s.awake < s.particles.size() &&
           space.maximum(s.awake, [=] RECOAT_LAMBDA(std::size_t i) { return disturbed(i) ? 1.0 : 0.0; }) > 0;
}

/// Stops the particles from `from` on for good; returns the kinetic energy that they had at the time of the positions
/// [J].
template <class Space>
double stop_motion(Space& space, SnapshotOf<Space>& s, std::size_t from, const AnySizes& sizes) {
    const ParticleView p = s.particles.view();
    const std::size_t count = s.particles.size() - from;
    const double energy = space.sum(count, [=] RECOAT_LAMBDA(std::size_t k) {
        const double radius = p.position[from + k].w;
        return 0.5 * sizes.mass_of(radius) * squared_norm(p.contact_velocity[from + k].xyz()) +
               0.5 * sizes.inertia_of(radius) * squared_norm(p.contact_spin[from + k].xyz());
    });
    space.for_each(count, [=] RECOAT_LAMBDA(std::size_t k) {
        p.velocity[from + k] = p.spin[from + k] = p.contact_velocity[from + k] = p.contact_spin[from + k] = row({});
    });
    return energy;
}

}  // namespace recoat
