#pragma once

#include "common/config.hpp"
#include "solver/scene/scene.hpp"

namespace recoat {

/// Expands `duration`, or the list `stages`, into segments [paper section 3].
///
/// Every stage lasts a whole number of steps; where a wall has a distance to go, its speed is adjusted within half a
/// step so that it arrives exactly. Needs walls, model, time step and (for spread) geometry of `scene`; adds the
/// spreading length. `blade_height` [m] is the clearance before the first stage, `lift_speed` [m/s] that of lifting the
/// blade. Throws InputError.
void read_stages(const Config& config, double blade_height, double lift_speed, Scene& scene);

}  // namespace recoat
