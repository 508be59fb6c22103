#include "analyzer/metrics/chamber_pores.hpp"

#include <algorithm>

#include <tbb/parallel_invoke.h>

#include "analyzer/fields/greedy_circles.hpp"

namespace recoat {
namespace {

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
    std::vector<Circle> separate, disjoint;
    tbb::parallel_invoke([&] { separate = greedy_circles(circles.maxima, layer.width, {.factor = config.chamber_f}); },
                         [&] { disjoint = greedy_circles(circles.maxima, layer.width, {.overlap = true}); });
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
