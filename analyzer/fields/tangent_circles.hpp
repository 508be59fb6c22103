#pragma once

#include <array>
#include <vector>

#include "analyzer/fields/top_view.hpp"

namespace recoat {

/// Circles that touch three disks from outside and have them all round: no half-plane through the centre holds the
/// three points of contact inside it. `disks` go round counter-clockwise. None, one, rarely two.
[[nodiscard]] std::vector<Circle> circles_between(const std::array<Disk, 3>& disks);

/// All circles of positive radius that touch three disks all round and overlap none, for disks of any radii: from the
/// Apollonius graph (additively weighted Voronoi diagram) of the disks and their copies within half a period. Circles
/// that touch more than three disks may appear several times.
[[nodiscard]] std::vector<Circle> tangent_circles(const TopView& view);

}  // namespace recoat
