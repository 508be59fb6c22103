#pragma once

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
