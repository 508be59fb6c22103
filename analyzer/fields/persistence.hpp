#pragma once

#include <vector>

#include "analyzer/fields/voronoi_graph.hpp"

namespace recoat {

/// Persistence of the vertices of a graph: how far the gap must fall, at least, on any way from the vertex to one with
/// a larger gap; the whole gap where ways lead to no larger one. 0 for a vertex that is not a maximum of the graph.
/// Vertices outside [x_min, x_max] have 0 too, and no way leads through them: there the gap grows without end.
/// Ways pass where the gap is positive only; vertices without a gap have 0. Of equal gaps the first by x and y counts
/// as the larger.
[[nodiscard]] std::vector<double> persistence(const VoronoiGraph& graph, double x_min, double x_max);

}  // namespace recoat
