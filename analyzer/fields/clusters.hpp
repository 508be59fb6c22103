#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "analyzer/fields/contact_graph.hpp"
#include "analyzer/fields/layer.hpp"

namespace recoat {

/// One connected component of the contact graph.
struct Cluster {
    std::size_t size = 0;
    bool percolates = false;  ///< winds round the y period: two ways to a particle differ by a period, be it one that
                              ///< touches its own image
    bool isotropic = false;   ///< no direction stands out in the top view (square, triangle, upright doublet)
    std::optional<double> angle;  ///< of the long axis to the spreading direction, in [0, 90] [deg]
};

/// Clusters of a whole file, single particles among them, in the order of their first particles.
struct Clusters {
    std::vector<Cluster> cluster;
    std::vector<std::size_t> of_particle;  ///< [N] index of the cluster of every particle
};

/// Connected components, and the axes of those of two particles or more from the gyration tensor of the centres in x
/// and y, unwrapped along the contacts, breadth first.
[[nodiscard]] Clusters find_clusters(const Layer& layer, const ContactGraph& graph);

}  // namespace recoat
