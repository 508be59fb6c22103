#pragma once

#include <filesystem>

#include "common/config.hpp"
#include "solver/scene/scene.hpp"

namespace recoat {

/// Reads what a scene of kind `spread` has beyond the model: powder or start_from, box, blade, stages. Throws
/// InputError.
void read_spread_scene(const Config& config, const std::filesystem::path& folder, Scene& scene);

}  // namespace recoat
