#pragma once

#include "solver/engine/engine.hpp"
#include "solver/scene/particle_csv.hpp"
#include "solver/scene/scene.hpp"

namespace recoat {

/// The particles that a scene starts with. Throws InputError when a table or state file cannot be used.
ParticleTable initial_particles(const Scene& scene, FileWarnings warnings = FileWarnings::show);

}  // namespace recoat
