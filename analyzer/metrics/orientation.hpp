#pragma once

#include <array>
#include <string_view>
#include <vector>

#include "analyzer/fields/clusters.hpp"

namespace recoat {

/// Particles of the region whose cluster belongs to one group of sizes, by the angle of the cluster.
struct OrientationGroup {
    std::string_view name;
    std::size_t particles = 0;
    std::size_t particles_without_angle = 0;  ///< cluster percolates or is isotropic
    std::vector<std::size_t> counts;          ///< per bin; the last bin holds 90 degrees
    std::vector<double> fraction_of_all;  ///< counts over all particles of the region, so that groups can be stacked
};

struct OrientationMetrics {
    std::vector<double> bin_edges;  ///< [deg]
    std::array<OrientationGroup, 3> groups;

    /// Group of clusters of this size, at least 2.
    [[nodiscard]] const OrientationGroup& group_of(std::size_t cluster_size) const {
        return groups[group_index(cluster_size)];
    }
    [[nodiscard]] static std::size_t group_index(std::size_t cluster_size) {
        return cluster_size == 2 ? 0 : cluster_size <= 4 ? 1 : 2;
    }
};

/// Groups 2, 3-4 and >=5. `bin` in degrees; one within `tolerance` bins below an edge counts as on it.
[[nodiscard]] OrientationMetrics orientation_metrics(const Layer& layer, const Clusters& clusters, double bin,
                                                     double tolerance);

}  // namespace recoat
