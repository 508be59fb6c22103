#include "analyzer/metrics/cluster_sizes.hpp"

#include <algorithm>

namespace recoat {

ClusterSizeMetrics cluster_size_metrics(const Layer& layer, const Clusters& clusters) {
    ClusterSizeMetrics metrics;
    for (const Cluster& cluster : clusters.cluster) {
        metrics.n_clusters += cluster.size >= 2;
        metrics.n_percolating += cluster.percolates;
        metrics.n_isotropic += cluster.isotropic;
        metrics.max_cluster_size = std::max(metrics.max_cluster_size, cluster.size);
    }
    std::map<std::size_t, std::size_t> particles;
    std::size_t total = 0;
    for (std::size_t i = 0; i < layer.size(); ++i) {
        if (!layer.in_region[i]) continue;
        ++particles[clusters.cluster[clusters.of_particle[i]].size];
        ++total;
    }
    for (const auto& [size, count] : particles) {
        metrics.size_fraction[size] = static_cast<double>(count) / static_cast<double>(total);
    }
    return metrics;
}

}  // namespace recoat
