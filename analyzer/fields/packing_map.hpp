#pragma once

#include "analyzer/configuration.hpp"
#include "analyzer/fields/layer.hpp"
#include "analyzer/fields/map.hpp"

namespace recoat {

/// Local packing density at the nodes of the grid, index [ix][iy] [-] [paper eq. 13].
struct PackingMaps {
    Map exact;   ///< volume of the spheres in the box over the window, from the base to h_b, in closed form
    Map centre;  ///< whole volumes of the spheres whose centre is in that box (half-open)
};

/// Nodes of the packing map along x: the first and the number of them. Fewer than the grid has where the windows of the
/// outer nodes reach out of the region and `edge` drops them; the number may be 0.
struct NodeRange {
    int first = 0, count = 0;
};
[[nodiscard]] NodeRange packing_nodes(const Grid& grid, double window, WindowEdge edge);

/// Linear in the number of particles and of nodes. Every sphere is cut once along all window edges that cross it.
[[nodiscard]] PackingMaps packing_maps(const Layer& layer, const AnalysisConfig& config);

}  // namespace recoat
