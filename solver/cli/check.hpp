#pragma once

#include <filesystem>
#include <string>

#include "solver/scene/engine_factory.hpp"
#include "solver/scene/scene.hpp"

namespace recoat {

/// What `recoat-solve check` prints: every derived number of the scene, each limit of the time step with its formula
/// and the chosen step's share of it, steps per stage, expected run time, memory and output, and notes on what is
/// probably not meant. As text, or as JSON in SI units (inertial lengths in d_p). `folder`: where the run will write.
std::string check_report(const Scene& scene, const Resources& resources, const std::filesystem::path& folder, bool json,
                         const EngineFactory& factory);

}  // namespace recoat
