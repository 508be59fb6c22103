#pragma once

#include <map>

#include "analyzer/fields/clusters.hpp"

namespace recoat {

/// Clusters by size. Numbers of clusters are over the whole file, shares over the particles of the region.
struct ClusterSizeMetrics {
    std::size_t n_clusters = 0;                   ///< of two particles or more
    std::size_t n_percolating = 0;                ///< round the y period, single particles that touch their images too
    std::size_t n_isotropic = 0;                  ///< of these, without a direction in the top view
    std::size_t max_cluster_size = 0;             ///< over all clusters of the file
    std::map<std::size_t, double> size_fraction;  ///< share of the particles that belong to a cluster of that size
};

[[nodiscard]] ClusterSizeMetrics cluster_size_metrics(const Layer& layer, const Clusters& clusters);

}  // namespace recoat
