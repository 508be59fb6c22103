#pragma once

#include "solver/engine/snapshot.hpp"

namespace recoat {

/// Wraps y and puts particles that are close in space close in memory; contacts follow their particles.
/// Throws SimulationFault when a particle has left the domain.
void sort_in_space(Snapshot& snapshot, const EngineSetup& setup, double skin);

}  // namespace recoat
