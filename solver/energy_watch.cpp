#include "solver/energy_watch.hpp"

#include <cmath>

#include <fmt/format.h>

#include "common/error.hpp"
#include "solver/contact/material.hpp"
#include "solver/output/energy_balance.hpp"
#include "solver/scene/contact_frequency.hpp"

namespace recoat {
namespace {

struct Stiffest {
    std::int64_t first = -1, second = -1;
    double frequency = 0;  ///< [1/s]
};

Stiffest stiffest_contact(const Engine& engine, const ParticleTable& particles, const ContactModel& model) {
    Stiffest worst;
    const auto radius = [&](std::int64_t i) { return particles.radius[static_cast<std::size_t>(i)]; };
    for (const ContactState& contact : engine.contacts()) {
        const ContactPartners partners = contact.second < 0
                                             ? with_wall(radius(contact.first), model.density)
                                             : pair_of(radius(contact.first), radius(contact.second), model.density);
        const double frequency = contact_frequency(model, partners, std::max(0.0, -contact.separation));
        if (frequency > worst.frequency) worst = {contact.first, contact.second, frequency};
    }
    return worst;
}

std::string partner_name(const Engine& engine, std::int64_t partner) {
    if (partner >= 0) return fmt::format("particle {}", partner);
    return fmt::format("wall '{}'", engine.walls()[static_cast<std::size_t>(-1 - partner)].name);
}

std::size_t fastest(const ParticleTable& particles) {
    std::size_t found = 0;
    for (std::size_t i = 1; i < particles.size(); ++i) {
        if (squared_norm(particles.velocity[i]) > squared_norm(particles.velocity[found])) found = i;
    }
    return found;
}

/// Which particle is likely to be the cause.
std::string suspect(const Engine& engine, const ParticleTable& particles, const Scene& scene) {
    const Stiffest worst = stiffest_contact(engine, particles, scene.model);
    if (worst.first < 0) return fmt::format("nothing touches now, and particle {} is the fastest", fastest(particles));
    return fmt::format("the stiffest contact now is that of particle {} and {}, of frequency w with w dt = {:.3g}",
                       worst.first, partner_name(engine, worst.second), worst.frequency * scene.time_step);
}

}  // namespace

double total_mass(const ParticleTable& particles, double density) {
    double mass = 0;
    for (const double radius : particles.radius) mass += sphere_mass(radius, density);
    return mass;
}

double energy_scale(const Scene& scene, const EnergyLedger& start, const EnergyLedger& end, double mass) {
    return energy_balance(start, end).exchanged + EnergyWatch::always * mass * scene.reference_gravity * scene.diameter;
}

EnergyWatch::EnergyWatch(const Scene& scene, const EnergyLedger& start, const ParticleTable& particles)
    : scene_(scene), start_(start), mass_(total_mass(particles, scene.model.density)) {}

void EnergyWatch::check(const Engine& engine) const {
    const EnergyLedger now = engine.ledger();
    const double error = energy_balance(start_, now).error, scale = energy_scale(scene_, start_, now, mass_);
    if (std::abs(error) <= limit * scale) return;
    throw SimulationFault(
        fmt::format("step {} (t = {:.6g} s): energy {}: {:.3g} J, {:.3g} of all energy exchanged since the start and "
                    "more than {:g} "
                    "of it, are not accounted for; the time step is too large for the contacts ({}): reduce time_step",
                    engine.step(), engine.time(), error > 0 ? "appears" : "vanishes", error, std::abs(error) / scale,
                    limit, suspect(engine, engine.particles(), scene_)));
}

}  // namespace recoat
