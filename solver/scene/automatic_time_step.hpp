#pragma once

#include "solver/scene/scene.hpp"

namespace recoat {

/// The longest step [s] whose error in the capture velocity stays below 1 % and whose layers cannot be told from those
/// of shorter steps [docs/accuracy.md]: a share of the contact time of the smallest spheres at the scene's speed, and a
/// share of the time in which the attraction carries them over s_min; rounded down to two digits.
double automatic_time_step(const Scene& scene);

}  // namespace recoat
