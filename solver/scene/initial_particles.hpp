#pragma once

#include "solver/engine/engine.hpp"
#include "solver/scene/scene.hpp"

namespace recoat {

/// The particles that a scene starts with. Throws InputError when a table or state file cannot be used.
ParticleTable initial_particles(const Scene& scene);

}  // namespace recoat
