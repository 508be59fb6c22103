#pragma once

#include <vector>

#include "common/error.hpp"
#include "solver/engine/snapshot.hpp"
#include "solver/engine/step_control.hpp"

namespace recoat {

// What can be read off a snapshot on the host, whichever space made it.

/// Contacts with first < second, sorted; forces are those at the present positions.
std::vector<ContactState> contacts_of(Snapshot snapshot, const EngineSetup& setup);

/// What the contact forces of the step that begins now will book of losses and work of walls: their powers at the
/// present positions, times the step [J]. Half of it belongs to the time up to now: the ledger is the trapezoidal rule
/// of the powers. Not so the attraction, whose work is that between two positions, nor rolling resistance, which may
/// stop a spin within a step [docs/stability.md].
Totals next_bookings(Snapshot snapshot, const EngineSetup& setup);

/// Energies that particles and contacts hold now, and lost since the start [J].
EnergyLedger ledger_of(const Snapshot& snapshot, const EngineSetup& setup);

/// Fills in what a snapshot leaves out because it follows from the rest: where contacts are found, room for a step.
void complete(Snapshot& snapshot, const EngineSetup& setup);

/// The sentence for a step that stopped for `halt`; `snapshot` is that of the moment before.
SimulationFault fault_of(Snapshot snapshot, const EngineSetup& setup, Halt halt);

}  // namespace recoat
