#include "analyzer/metrics/chamber_pores.hpp"

#include <algorithm>
#include <functional>

#include "analyzer/fields/disk_index.hpp"

namespace recoat {
namespace {

/// From large to small, each that meets none of those selected before. meets(selected, candidate, distance of centres)
/// is true only if the distance is at most reach(selected) + own_reach(candidate).
template <class Meets, class Reach, class OwnReach>
std::vector<Circle> greedy(const std::vector<Circle>& candidates, double period, Meets meets, Reach reach,
                           OwnReach own_reach) {
    if (candidates.empty()) return {};
    const auto [left, right] = std::ranges::minmax(candidates, {}, &Circle::x);
    DiskIndex index(left.x, right.x, period, candidates.size());
    std::vector<Circle> selected;
    for (const Circle& circle : candidates) {
        const bool taken =
            index.any_near(circle.x, circle.y, own_reach(circle),
                           [&](const Circle& other, double distance) { return meets(other, circle, distance); });
        if (taken) continue;
        index.add(circle, reach(circle));
        selected.push_back(circle);
    }
    return selected;
}

/// Whether a circle is counted as one of the region.
class RegionRule {
public:
    RegionRule(const Layer& layer, const AnalysisConfig& config) : length_(layer.length), config_(config) {}

    [[nodiscard]] bool holds(const Circle& circle) const {
        const double tolerance = config_.bin_tol;
        if (2 * circle.radius < config_.chamber_min_diameter) return false;
        if (config_.chamber_x_edge == ChamberEdge::inside) {
            return circle.x - circle.radius >= -tolerance && circle.x + circle.radius <= length_ + tolerance;
        }
        return circle.x >= -tolerance && circle.x < length_ - tolerance;
    }
    [[nodiscard]] ChamberPores apply(const std::vector<Circle>& circles) const {
        ChamberPores pores;
        std::ranges::copy_if(circles, std::back_inserter(pores.circles), [&](const Circle& c) { return holds(c); });
        set_sizes(pores);
        return pores;
    }
    [[nodiscard]] ChamberPores apply(const std::vector<PersistentCircle>& circles) const {
        ChamberPores pores;
        for (const auto& [circle, persistence] : circles) {
            if (persistence < config_.chamber_persistence || !holds(circle)) continue;
            pores.circles.push_back(circle);
            pores.persistence.push_back(persistence);
        }
        set_sizes(pores);
        return pores;
    }

private:
    void set_sizes(ChamberPores& pores) const {
        std::vector<double> diameters;
        for (const Circle& circle : pores.circles) diameters.push_back(2 * circle.radius);
        pores.sizes = pore_sizes(std::move(diameters), config_.bin_tol);
    }

    double length_;
    const AnalysisConfig& config_;
};

}  // namespace

ChamberPoreMetrics chamber_pore_metrics(const Layer& layer, const AnalysisConfig& config) {
    const EmptyCircles circles = empty_circles(layer);
    const double factor = config.chamber_f;
    const auto nothing = [](const Circle&) { return 0.0; };
    const std::vector<Circle> separate = greedy(
        circles.maxima, layer.width,
        [&](const Circle& other, const Circle&, double distance) { return distance < factor * other.radius; },
        [&](const Circle& circle) { return factor * circle.radius; }, nothing);
    const std::vector<Circle> disjoint = greedy(
        circles.maxima, layer.width,
        [](const Circle& other, const Circle& circle, double distance) {
            return distance < other.radius + circle.radius;
        },
        std::mem_fn(&Circle::radius), std::mem_fn(&Circle::radius));
    const RegionRule region(layer, config);
    ChamberPoreMetrics metrics;
    metrics.all = region.apply(circles.maxima);
    metrics.separate = region.apply(separate);
    metrics.disjoint = region.apply(disjoint);
    if (circles.persistent) metrics.persistent = region.apply(*circles.persistent);
    if (metrics.separate.circles.empty()) return metrics;
    const auto [first, last] = std::ranges::minmax(layer.x);
    metrics.n_beyond_data = static_cast<std::size_t>(
        std::ranges::count_if(metrics.separate.circles, [low = first, high = last](const Circle& circle) {
            return circle.x - circle.radius < low || circle.x + circle.radius > high;
        }));
    return metrics;
}

}  // namespace recoat
