#include "analyzer/metrics/coordination.hpp"

#include <algorithm>

namespace recoat {

std::vector<double> shares(const std::vector<std::size_t>& counts, std::size_t total) {
    std::vector<double> result(counts.size(), 0);
    if (total == 0) return result;
    std::ranges::transform(counts, result.begin(),
                           [&](std::size_t count) { return static_cast<double>(count) / static_cast<double>(total); });
    return result;
}

CoordinationMetrics coordination_metrics(const Layer& layer, const ContactGraph& graph) {
    CoordinationMetrics metrics;
    metrics.n_contacts = graph.contacts();
    metrics.cn_counts.assign(1, 0);
    std::size_t sum = 0;
    for (std::size_t i = 0; i < layer.size(); ++i) {
        if (!layer.in_region[i]) continue;
        const std::size_t number = graph.coordination_number(i);
        if (metrics.cn_counts.size() <= number) metrics.cn_counts.resize(number + 1, 0);
        ++metrics.cn_counts[number];
        ++metrics.n_particles;
        sum += number;
    }
    metrics.cn_fraction = shares(metrics.cn_counts, metrics.n_particles);
    if (metrics.n_particles > 0) metrics.cn_mean = static_cast<double>(sum) / static_cast<double>(metrics.n_particles);
    return metrics;
}

}  // namespace recoat
