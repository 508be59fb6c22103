#pragma once

#include <filesystem>

#include "solver/engine/engine.hpp"

namespace recoat {

/// Reads a table of particles by the rules of read_csv_table(): x, y, z and radius or diameter in metres where they
/// name no unit; particles rest where there are no velocities, and do not turn where there are no angular velocities.
/// What else the user should know goes to standard error. Throws InputError "file:line: sentence" when the table is
/// damaged, has no particles or only some components of a velocity.
ParticleTable read_particle_csv(const std::filesystem::path& file);

}  // namespace recoat
