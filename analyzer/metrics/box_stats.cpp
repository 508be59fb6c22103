#include "analyzer/metrics/box_stats.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>

#include "analyzer/fields/sort_in_pieces.hpp"

namespace recoat {
namespace {

/// Equal values that differ by round-off are no outliers of one another [in units of the largest value].
constexpr double round_off = 1e-12;

}  // namespace

double quantile(std::span<const double> sorted, double share) {
    const double place = share * static_cast<double>(sorted.size() - 1);
    const auto below = static_cast<std::size_t>(place);
    const std::size_t above = std::min(below + 1, sorted.size() - 1);
    return std::lerp(sorted[below], sorted[above], place - static_cast<double>(below));
}

double mean(std::span<const double> values) {
    if (values.empty()) return 0;
    return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

BoxStats box_stats(std::span<const double> values) {
    BoxStats stats;
    if (values.empty()) return stats;
    std::vector<double> sorted(values.begin(), values.end());
    sort_in_pieces(sorted, std::identity{}, std::less<>{});
    stats.n = sorted.size();
    stats.mean = mean(values);
    stats.min = sorted.front();
    stats.max = sorted.back();
    stats.q1 = quantile(sorted, 0.25);
    stats.median = quantile(sorted, 0.5);
    stats.q3 = quantile(sorted, 0.75);
    stats.iqr = stats.q3 - stats.q1;
    if (stats.median != 0) stats.iqr_over_median = stats.iqr / stats.median;
    const double slack = 1.5 * stats.iqr + round_off * std::max(std::abs(stats.min), std::abs(stats.max));
    const auto first = std::ranges::lower_bound(sorted, stats.q1 - slack);
    const auto last = std::ranges::upper_bound(sorted, stats.q3 + slack);
    stats.whisker_lo = *first;
    stats.whisker_hi = *(last - 1);
    stats.n_outliers = stats.n - static_cast<std::size_t>(last - first);
    return stats;
}

}  // namespace recoat
