#pragma once

#include "solver/engine/engine.hpp"

namespace recoat {

/// How well energy is accounted for between two moments.
struct EnergyBalance {
    double wall_work = 0;   ///< of moving walls on the particles [J]
    double dissipated = 0;  ///< [J]
    double error = 0;       ///< change of (stored + removed with walls) + dissipated - wall_work [J]
    double scale = 0;       ///< |wall_work|, or where no wall did work the dissipated energy [J]
    double exchanged = 0;   ///< all that was there to be exchanged, or was exchanged, between the forms of energy [J]

    /// Error over scale; 0 where nothing happened.
    [[nodiscard]] double relative_error() const;
};

EnergyBalance energy_balance(const EnergyLedger& start, const EnergyLedger& end);

}  // namespace recoat
