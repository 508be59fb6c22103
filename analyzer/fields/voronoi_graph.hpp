#pragma once

#include <cstddef>
#include <vector>

#include "analyzer/fields/top_view.hpp"

namespace recoat {

/// Way between two vertices of a Voronoi graph along which the gap to the disks is at least `throat`.
struct VoronoiEdge {
    std::size_t first = 0, second = 0;
    double throat = 0;  ///< smallest gap on the way [d_p]; negative where the disks overlap
};

/// Voronoi diagram of the centres of disks of equal radii, periodic along y. Its vertices are circles that touch three
/// disks or more and hold none; their radius is the gap between vertex and disks, negative where disks overlap.
/// Vertices of four or more cocircular centres appear several times, joined by edges of no length.
struct VoronoiGraph {
    std::vector<Circle> vertices;
    std::vector<bool> is_maximum;  ///< whether the gap is less everywhere around the vertex
    std::vector<VoronoiEdge> edges;
};

/// The diagram between the outermost centres along x, from Delaunay triangulations of blocks of the top view: a vertex
/// depends on no centre farther away than the nearest. Linear in the number of disks but for sorting.
[[nodiscard]] VoronoiGraph voronoi_graph(const TopView& view);

}  // namespace recoat
