#pragma once

#include "common/config.hpp"
#include "solver/scene/size_distribution.hpp"

namespace recoat {

/// Reads the section `sizes` of a powder. Throws InputError.
SizeDistribution read_sizes(const Config& sizes);

}  // namespace recoat
