#pragma once

#include <string>

#include "solver/scene/engine_factory.hpp"
#include "solver/scene/scene.hpp"

namespace recoat {

/// What `recoat-solve check` prints: every derived number of the scene, each limit of the time step with its formula
/// and the chosen step's share of it, steps per stage, expected run time and memory. As text, or as JSON in SI units
/// (inertial lengths in d_p).
std::string check_report(const Scene& scene, const Resources& resources, bool json, const EngineFactory& factory);

}  // namespace recoat
