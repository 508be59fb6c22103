#pragma once

#include <functional>
#include <memory>
#include <vector>

#include "solver/engine/engine.hpp"

namespace recoat {

/// How engines come to be; tests put another one here.
struct EngineFactory {
    std::function<std::unique_ptr<Engine>(const EngineSetup&, const ParticleTable&, std::vector<Wall>)> make;
    std::function<std::unique_ptr<Engine>(const EngineSetup&, const EngineState&)> restore;
};

}  // namespace recoat
