#pragma once

#include <filesystem>

#include "common/config.hpp"
#include "solver/scene/scene.hpp"

namespace recoat {

/// Reads what a scene of kind `particles` has beyond the model: particles or start_from, walls, y_period, and duration
/// or stages. Throws InputError.
void read_particle_scene(const Config& config, const std::filesystem::path& folder, Scene& scene);

}  // namespace recoat
