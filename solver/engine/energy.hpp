#pragma once

#include <algorithm>
#include <numeric>
#include <vector>

#include "solver/contact/law.hpp"
#include "solver/engine/engine.hpp"
#include "solver/engine/snapshot.hpp"
#include "solver/execution/reductions.hpp"

namespace recoat {

struct KineticEnergy {
    double translation = 0, rotation = 0;

    [[nodiscard]] double total() const { return translation + rotation; }
};

/// Kinetic energy of translation of particle i [J].
template <class Sizes>
struct TranslationOf {
    Sizes sizes;
    const Row *position, *velocity;
    RECOAT_HD double operator()(std::size_t i) const {
        return 0.5 * sizes.mass_of(position[i].w) * squared_norm(velocity[i].xyz());
    }
};

/// And of rotation [J].
template <class Sizes>
struct RotationOf {
    Sizes sizes;
    const Row *position, *spin;
    RECOAT_HD double operator()(std::size_t i) const {
        return 0.5 * sizes.inertia_of(position[i].w) * squared_norm(spin[i].xyz());
    }
};

/// Kinetic energy at the time of the positions, summed where the particles are [J].
template <class Space, class Sizes>
KineticEnergy kinetic(Space& space, const ParticleArrays<Space>& p, const Sizes& sizes) {
    const Row* position = p.position.data();
    const auto sums = space.reduce(SumOf<TranslationOf<Sizes>>{p.size(), {sizes, position, p.contact_velocity.data()}},
                                   SumOf<RotationOf<Sizes>>{p.size(), {sizes, position, p.contact_spin.data()}});
    return {sums[0], sums[1]};
}

/// Kinetic energy of particle i, none for those ahead that nobody waits for [J].
template <class Sizes>
struct KineticBehind {
    TranslationOf<Sizes> translation;
    RotationOf<Sizes> rotation;
    double front;  ///< as RestLimit::front

    RECOAT_HD double operator()(std::size_t i) const {
        const bool gone = translation.position[i].x > front && translation.velocity[i].x > 0;
        return gone ? 0 : translation(i) + rotation(i);
    }
};

template <class Space, class Sizes>
KineticBehind<Sizes> kinetic_behind(const ParticleArrays<Space>& p, const Sizes& sizes, double front) {
    const Row* position = p.position.data();
    return {{sizes, position, p.contact_velocity.data()}, {sizes, position, p.contact_spin.data()}, front};
}

/// Bounds of the energy that a RestLimit is about [J].
struct RestBounds {
    double lower = 0, upper = 0;
};

/// Of the first `awake` particles; the others hold none.
template <class Space, class Sizes>
RestBounds rest_bounds(Space& space, const ParticleArrays<Space>& p, std::size_t awake, const Sizes& sizes,
                       const RestLimit& limit) {
    const auto energy = kinetic_behind(p, sizes, limit.front);
    const auto found = space.reduce(SumOf{awake, energy}, MaximumOf{awake, energy});
    if (limit.stragglers >= awake) return {};
    return {found[0] - static_cast<double>(limit.stragglers) * std::max(0.0, found[1]), found[0]};
}

/// The energy itself, added up from the least [J].
template <class Sizes>
double energy_without(const Particles& p, std::size_t awake, const Sizes& sizes, const RestLimit& limit) {
    const auto energy = kinetic_behind(p, sizes, limit.front);
    std::vector<double> energies(awake);
    for (std::size_t i = 0; i < awake; ++i) energies[i] = energy(i);
    std::sort(energies.begin(), energies.end());
    energies.resize(awake - std::min(limit.stragglers, awake));
    return std::accumulate(energies.begin(), energies.end(), 0.0);
}

/// Kinetic and gravitational energy; the latter is 0 for centres in the origin [J].
template <class Sizes>
EnergyLedger particle_energies(const Particles& p, const Sizes& sizes, Vec3 gravity) {
    EnergyLedger ledger;
    OpenMP space(1);
    const KineticEnergy motion = kinetic(space, p, sizes);
    ledger.kinetic_translation = motion.translation;
    ledger.kinetic_rotation = motion.rotation;
    for (std::size_t i = 0; i < p.size(); ++i)
        ledger.gravity -= sizes.mass_of(p.position[i].w) * dot(gravity, p.position[i].xyz());
    return ledger;
}

/// Adds what one contact stores: 2/5 k_H d^(5/2), the friction spring, and minus the well of the attraction [J].
template <bool cohesive>
void add_contact_energy(EnergyLedger& ledger, const ContactLaw<cohesive>& law, const Attraction& attraction,
                        double separation, double last_attraction, Vec3 slip, const Coefficients& c) {
    const double overlap = separation < 0 ? -separation : 0;
    const double root = std::sqrt(overlap);
    const double elastic = law.hertz.elastic(overlap, root, c);
    const auto load =
        law.friction_load(FrictionLoad<double>{elastic, overlap, std::sqrt(root), 0}, last_attraction, separation, c);
    ledger.elastic_normal += law.hertz.energy(overlap, c);
    ledger.elastic_tangential += law.mindlin.energy(slip, load.force, load.overlap);
    if constexpr (cohesive) ledger.cohesion -= attraction.well(separation, c);
}

}  // namespace recoat
