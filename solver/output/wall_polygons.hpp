#pragma once

#include <vector>

#include "common/vec3.hpp"
#include "solver/engine/wall.hpp"

namespace recoat {

/// The box that walls are drawn in; they may be infinite themselves [m].
struct DrawnSpace {
    Vec3 lower, upper;
};

using Polygon = std::vector<Vec3>;  ///< corners in order [m]

/// The part of a wall's surface that lies in `space`: a plane is one polygon (none where it passes by), a box has its
/// faces, those that are cut off by the space included.
std::vector<Polygon> wall_polygons(const Wall& wall, const DrawnSpace& space);

}  // namespace recoat
