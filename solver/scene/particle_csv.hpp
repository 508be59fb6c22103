#pragma once

#include <filesystem>

#include "solver/engine/engine.hpp"

namespace recoat {

/// Whether sentences about a file of particles go to standard error.
enum class FileWarnings { show, leave_out };

/// Reads a table of particles by the rules of read_csv_table(): x, y, z and radius or diameter in metres where they
/// name no unit; particles rest where there are no velocities, and do not turn where there are no angular velocities.
/// Throws InputError "file:line: sentence" when the table is
/// damaged, has no particles or only some components of a velocity.
ParticleTable read_particle_csv(const std::filesystem::path& file, FileWarnings warnings = FileWarnings::show);

}  // namespace recoat
