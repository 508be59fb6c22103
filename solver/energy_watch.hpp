#pragma once

#include "solver/engine/engine.hpp"
#include "solver/scene/scene.hpp"

namespace recoat {

/// Watches, while a run goes on, that energy neither appears nor vanishes: the sign of a time step that is too large
/// [docs/stability.md].
class EnergyWatch {
public:
    /// Share of the energy exchanged since the start that may be unaccounted for.
    static constexpr double limit = 0.1;
    /// Steps between checks where no energy is written.
    static constexpr std::int64_t interval = 10000;
    /// Energy per particle, in m g d_p, that counts as exchanged in any case. A cohesive particle between two others
    /// that nearly touch gains a little in every step, since impulses of pairs do not know of each other: in a long
    /// rest that must not look like an instability, which passes any such bound within some steps.
    static constexpr double always = 1;

    /// `start`: ledger at the start of the run; `particles`: those of the run, at any time.
    EnergyWatch(const Scene& scene, const EnergyLedger& start, const ParticleTable& particles);

    /// Throws SimulationFault with a sentence that names the step, the stiffest contact and the cause.
    void check(const Engine& engine) const;

private:
    const Scene& scene_;
    EnergyLedger start_;
    double mass_;  ///< of all particles [kg]
};

/// What the watch compares with: the energy exchanged between two moments, and m g d_p of particles of `mass` [J].
double energy_scale(const Scene& scene, const EnergyLedger& start, const EnergyLedger& end, double mass);

/// Of all particles [kg].
double total_mass(const ParticleTable& particles, double density);

}  // namespace recoat
