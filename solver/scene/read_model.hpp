#pragma once

#include "common/config.hpp"
#include "solver/scene/scene.hpp"

namespace recoat {

/// Reads the sections material, contact and cohesion and the keys gravity, stiffness_ratio, pair_lists and sleep into
/// `scene`. Sets the particle diameter of `config`, so that the unit dp may be used from here on. Throws InputError.
void read_model(Config& config, Scene& scene);

}  // namespace recoat
