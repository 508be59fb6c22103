#pragma once

#include "common/config.hpp"
#include "solver/scene/scene.hpp"

namespace recoat {

/// Expands `duration`, or the list `stages`, into segments [paper section 3].
///
/// Every stage lasts a whole number of steps; where a wall has a distance to go, its speed is adjusted within half a
/// step so that it arrives exactly. Needs walls, model, time step and (for spread) geometry of `scene`; adds the
/// spreading length. `lift_speed` [m/s] is that of lifting the blade. Throws InputError, also for what cannot work:
/// walls that would run into each other, leave the domain or stand in the way of the blade.
void read_stages(const Config& config, double lift_speed, Scene& scene);

}  // namespace recoat
