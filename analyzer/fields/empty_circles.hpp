#pragma once

#include <optional>
#include <vector>

#include "analyzer/fields/top_view.hpp"

namespace recoat {

/// A circle with its persistence [d_p].
struct PersistentCircle {
    Circle circle;
    double persistence = 0;
};

/// What fits between the disks of a layer seen from above.
struct EmptyCircles {
    /// Every local maximum of the gap to the disks, of the whole file; from large to small, then by x and y.
    std::vector<Circle> maxima;
    /// Vertices of the Voronoi graph with positive persistence, in the same order; none for unequal radii. Beyond the
    /// outermost disks they need not be maxima of the gap.
    std::optional<std::vector<PersistentCircle>> persistent;
};

/// Exact: from the Delaunay triangulation for equal radii, from the Apollonius graph otherwise. Circles closer to each
/// other than the tolerance of coincidence count once.
[[nodiscard]] EmptyCircles empty_circles(const Layer& layer);

}  // namespace recoat
