#pragma once

#include <string>

#include "common/state.hpp"
#include "solver/engine/engine.hpp"
#include "solver/scene/scene.hpp"

namespace recoat {

/// The particles of the moment, with CoordinationNumber.
State state_of_engine(const Engine& engine, double y_period);

/// What state files of a run say about it.
StateInfo state_info(const Scene& scene, const std::string& stage, Backend backend);

}  // namespace recoat
