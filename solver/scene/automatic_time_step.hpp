#pragma once

#include "solver/scene/scene.hpp"

namespace recoat {

/// The step [s] of a choice [docs/accuracy.md]: a share of the contact time of the smallest spheres at the scene's
/// speed, and a share of the time in which the attraction carries them over s_min; rounded down to two digits.
///
/// `automatic`: its error in the capture velocity stays below half a percent, and its beds and layers cannot be told
/// from those of shorter steps. `fast`: only the latter.
double chosen_time_step(const Scene& scene, TimeStepChoice choice);

}  // namespace recoat
