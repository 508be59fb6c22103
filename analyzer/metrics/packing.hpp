#pragma once

#include "analyzer/fields/map.hpp"

namespace recoat {

/// How far a map in its voxel form is from the exact one, over all nodes.
struct MapError {
    double max = 0;  ///< largest absolute difference
    double rms = 0;  ///< root of the mean squared difference
};

/// @throws std::invalid_argument when the maps differ in size.
[[nodiscard]] MapError map_error(const Map& approximate, const Map& exact);

}  // namespace recoat
