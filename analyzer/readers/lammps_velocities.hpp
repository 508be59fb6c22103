#pragma once

#include "analyzer/readers/source.hpp"
#include "common/tables/text_cursor.hpp"

namespace recoat {

/// Reads the lines of the section Velocities of a LAMMPS data file into `source`, whose particles have identities: one
/// line for each, "id vx vy vz", of spheres with "wx wy wz" behind. The cursor stands on the heading.
/// @throws InputError when a particle has no line, or a line no particle.
void read_lammps_velocities(TextCursor& cursor, Source& source);

}  // namespace recoat
