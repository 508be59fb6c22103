#pragma once

#include <string>

#include "analyzer/readers/source.hpp"

namespace recoat {

/// What holds for every format: leaves out what the user does not want, brings lengths to metres, fills in the radii
/// that the user gives, and checks the particles. Velocities that are not finite are left out, with a warning.
/// @throws InputError naming file, line and particle when an option does not apply, a position or radius is not finite,
/// a radius not above zero, an identity there twice, or a particle far outside the box.
void complete(Source& source, const std::string& file, const ReadOptions& options);

}  // namespace recoat
