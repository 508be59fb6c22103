#pragma once

#include <array>
#include <string_view>

#include "solver/engine/engine.hpp"

namespace recoat {

/// A named entry of the energy ledger.
struct LedgerField {
    std::string_view name;
    double EnergyLedger::*value;
};

/// All entries, in the order of every file.
inline constexpr std::array<LedgerField, 11> ledger_fields = {{
    {"kinetic_translation", &EnergyLedger::kinetic_translation},
    {"kinetic_rotation", &EnergyLedger::kinetic_rotation},
    {"elastic_normal", &EnergyLedger::elastic_normal},
    {"elastic_tangential", &EnergyLedger::elastic_tangential},
    {"gravity", &EnergyLedger::gravity},
    {"cohesion", &EnergyLedger::cohesion},
    {"dissipated_normal", &EnergyLedger::dissipated_normal},
    {"dissipated_tangential", &EnergyLedger::dissipated_tangential},
    {"dissipated_rolling", &EnergyLedger::dissipated_rolling},
    {"wall_work", &EnergyLedger::wall_work},
    {"removed_with_walls", &EnergyLedger::removed_with_walls},
}};

}  // namespace recoat
