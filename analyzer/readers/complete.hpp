#pragma once

#include <string>

#include "analyzer/readers/source.hpp"

namespace recoat {

/// What holds for every format: brings lengths to metres, fills in the constant radius, and checks the particles.
/// @throws InputError naming file, line and particle when an option does not apply, a position or radius is not finite,
/// a radius not above zero, an identity there twice, or a particle far outside the box.
void complete(Source& source, const std::string& file, const ReadOptions& options);

}  // namespace recoat
