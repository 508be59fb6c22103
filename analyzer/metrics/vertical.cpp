#include "analyzer/metrics/vertical.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "analyzer/metrics/coordination.hpp"

namespace recoat {

VerticalMetrics vertical_metrics(const Layer& layer, double bin, double tolerance) {
    std::vector<std::size_t> counts;
    std::size_t total = 0, above = 0, touching = 0;
    double sum = 0, highest = -std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < layer.size(); ++i) {
        if (!layer.in_region[i]) continue;
        const double z = layer.z[i];
        const auto k = static_cast<std::size_t>(std::max(std::floor(z / bin + 0.5 + tolerance), 0.0));
        if (counts.size() <= k) counts.resize(k + 1, 0);
        ++counts[k];
        ++total;
        sum += z;
        highest = std::max(highest, z);
        above += z > 1;
        touching += z - layer.radius[i] < touching_gap;
    }
    VerticalMetrics metrics;
    metrics.fraction = shares(counts, total);
    for (std::size_t k = 0; k < counts.size(); ++k) metrics.bin_centres.push_back(bin * static_cast<double>(k));
    if (total > 0) {
        const auto all = static_cast<double>(total);
        metrics.summary = {.mean = sum / all,
                           .max = highest,
                           .fraction_above_1dp = static_cast<double>(above) / all,
                           .fraction_touching_base = static_cast<double>(touching) / all};
    }
    return metrics;
}

}  // namespace recoat
