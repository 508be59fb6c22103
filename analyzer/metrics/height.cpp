#include "analyzer/metrics/height.hpp"

#include <algorithm>
#include <cmath>
#include <span>

#include "analyzer/metrics/box_stats.hpp"

namespace recoat {
namespace {

double mean_deviation(std::span<const double> values) {
    const double centre = mean(values);
    double sum = 0;
    for (const double value : values) sum += std::abs(value - centre);
    return values.empty() ? 0 : sum / static_cast<double>(values.size());
}

}  // namespace

HeightMetrics height_metrics(const Map& height, double bin, double tolerance) {
    HeightMetrics metrics;
    if (height.values.empty()) return metrics;
    const auto nodes = static_cast<double>(height.values.size());
    std::vector<double> nonempty;
    std::ranges::copy_if(height.values, std::back_inserter(nonempty), [](double h) { return h > 0; });
    std::vector<std::size_t> counts;
    for (const double h : nonempty) {
        const auto k = static_cast<std::size_t>(std::max(std::ceil(h / bin - tolerance), 1.0));
        if (counts.size() < k) counts.resize(k, 0);
        ++counts[k - 1];
    }
    for (std::size_t k = 0; k < counts.size(); ++k) {
        metrics.bin_upper_edges.push_back(bin * static_cast<double>(k + 1));
        metrics.fraction.push_back(static_cast<double>(counts[k]) / nodes);
    }
    metrics.empty_fraction = (nodes - static_cast<double>(nonempty.size())) / nodes;
    metrics.mean = mean(height.values);
    metrics.max = std::ranges::max(height.values);
    metrics.roughness = mean_deviation(height.values);
    metrics.roughness_nonempty = mean_deviation(nonempty);
    return metrics;
}

}  // namespace recoat
