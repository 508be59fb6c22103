#pragma once

#include "solver/engine/engine.hpp"

namespace recoat {

/// How well energy is accounted for between two moments.
struct EnergyBalance {
    double wall_work = 0;   ///< of moving walls on the particles [J]
    double dissipated = 0;  ///< [J]
    double error = 0;       ///< change of (stored + removed with walls) + dissipated - wall_work [J]
    double exchanged = 0;   ///< all that was there to be exchanged, or was exchanged, between the forms of energy [J]
    double held = 0;        ///< the larger, of start and end, sum of all stored forms without their signs [J]

    /// Share of `held` below which differences are those of rounding.
    static constexpr double rounding = 1e-9;

    /// What the error is compared with [J]: the energy exchanged, but never less than the rounding of what is held.
    [[nodiscard]] double scale() const;
    /// Error over scale; 0 where there is no energy at all.
    [[nodiscard]] double relative_error() const;
};

EnergyBalance energy_balance(const EnergyLedger& start, const EnergyLedger& end);

}  // namespace recoat
