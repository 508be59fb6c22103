#pragma once

#include <filesystem>
#include <string>

#include "analyzer/readers/source.hpp"

namespace recoat {

/// Writes particles in the format of this name, or, without one, that of the ending of the file: csv (.csv), vtp
/// (.vtp), lammps-dump (.dump, .lammpstrj), vtkhdf (.vtkhdf, .hdf). Positions and radii in metres, to the last bit, the
/// identities, and the velocities where the particles have them (NaN in VTKHDF where not); the box goes into a LAMMPS
/// dump, its period along y into VTKHDF. The file appears whole or not at all.
/// @throws InputError when no such format is known or the file cannot be written.
void write_particle_file(const std::filesystem::path& place, const std::string& format, const Source& source);

}  // namespace recoat
