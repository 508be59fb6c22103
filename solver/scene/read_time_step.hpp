#pragma once

#include "common/config.hpp"
#include "solver/scene/scene.hpp"

namespace recoat {

/// Reads time_step, or puts the automatic or the fast one in its place when it is absent, "auto" or "fast", in `config`
/// too, so that the resolved configuration names the step that was taken. Needs the model, the sizes and the reference
/// speed of `scene`. Throws InputError.
void read_time_step(const Config& config, Scene& scene);

}  // namespace recoat
