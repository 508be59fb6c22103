#pragma once

#include "common/error.hpp"
#include "solver/engine/engine.hpp"
#include "solver/engine/snapshot.hpp"

namespace recoat {

/// Sentences for what stops a run [SimulationFault].
SimulationFault overlap_fault(const Snapshot& snapshot, const EngineSetup& setup, std::int64_t first,
                              std::int64_t second, double overlap);
SimulationFault speed_fault(const Snapshot& snapshot, const EngineSetup& setup, std::int64_t particle, double limit);

/// Throws SimulationFault when a centre is outside the domain or not a number.
void require_inside(const Particles& particles, const EngineSetup& setup, std::int64_t step);

}  // namespace recoat
