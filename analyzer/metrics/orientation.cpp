#include "analyzer/metrics/orientation.hpp"

#include <algorithm>
#include <cmath>

#include "analyzer/metrics/coordination.hpp"

namespace recoat {
namespace {

constexpr double right_angle = 90;

}  // namespace

OrientationMetrics orientation_metrics(const Layer& layer, const Clusters& clusters, double bin, double tolerance) {
    OrientationMetrics metrics;
    const auto bins = static_cast<std::size_t>(std::ceil(right_angle / bin - tolerance));
    for (std::size_t k = 0; k <= bins; ++k) {
        metrics.bin_edges.push_back(std::min(bin * static_cast<double>(k), right_angle));
    }
    constexpr std::array<std::string_view, 3> names = {"2", "3-4", ">=5"};
    for (std::size_t g = 0; g < names.size(); ++g) {
        metrics.groups[g].name = names[g];
        metrics.groups[g].counts.assign(bins, 0);
    }
    std::size_t total = 0;
    for (std::size_t i = 0; i < layer.size(); ++i) {
        if (!layer.in_region[i]) continue;
        ++total;
        const Cluster& cluster = clusters.cluster[clusters.of_particle[i]];
        if (cluster.size < 2) continue;
        OrientationGroup& group = metrics.groups[OrientationMetrics::group_index(cluster.size)];
        ++group.particles;
        if (cluster.angle) {
            ++group.counts[std::min(static_cast<std::size_t>(*cluster.angle / bin + tolerance), bins - 1)];
        } else {
            ++group.particles_without_angle;
        }
    }
    for (OrientationGroup& group : metrics.groups) group.fraction_of_all = shares(group.counts, total);
    return metrics;
}

}  // namespace recoat
