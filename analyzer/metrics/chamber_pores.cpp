#include "analyzer/metrics/chamber_pores.hpp"

#include <algorithm>

#include <tbb/parallel_invoke.h>

#include "analyzer/fields/greedy_circles.hpp"

namespace recoat {
namespace {

void set_sizes(ChamberPores& pores, double tolerance) {
    std::vector<double> diameters;
    for (const Circle& circle : pores.circles) diameters.push_back(2 * circle.radius);
    pores.sizes = pore_sizes(std::move(diameters), tolerance);
}

ChamberPores chambers_of(const std::vector<Circle>& circles, const Layer& layer, const AnalysisConfig& config) {
    ChamberPores pores;
    std::ranges::copy_if(circles, std::back_inserter(pores.circles),
                         [&](const Circle& circle) { return is_chamber(circle, layer, config); });
    set_sizes(pores, config.bin_tol);
    return pores;
}

ChamberPores chambers_of(const std::vector<PersistentCircle>& circles, const Layer& layer,
                         const AnalysisConfig& config) {
    // A circle that another takes up within round-off is the same.
    const double least = std::max(config.chamber_persistence, coincidence_tolerance);
    ChamberPores pores;
    for (const auto& [circle, persistence] : circles) {
        if (persistence < least || !is_chamber(circle, layer, config)) continue;
        pores.circles.push_back(circle);
        pores.persistence.push_back(persistence);
    }
    set_sizes(pores, config.bin_tol);
    return pores;
}

}  // namespace

bool is_chamber(const Circle& circle, const Layer& layer, const AnalysisConfig& config) {
    const double tolerance = config.bin_tol;
    if (2 * circle.radius < std::max(config.chamber_min_diameter, smallest_chamber)) return false;
    if (config.chamber_x_edge == ChamberEdge::inside) {
        return circle.x - circle.radius >= -tolerance && circle.x + circle.radius <= layer.length + tolerance;
    }
    return circle.x >= -tolerance && circle.x < layer.length - tolerance;
}

ChamberPoreMetrics chamber_pore_metrics(const Layer& layer, const AnalysisConfig& config) {
    const EmptyCircles circles = empty_circles(layer);
    std::vector<Circle> separate, disjoint;
    tbb::parallel_invoke([&] { separate = greedy_circles(circles.maxima, layer.width, {.factor = config.chamber_f}); },
                         [&] { disjoint = greedy_circles(circles.maxima, layer.width, {.overlap = true}); });
    ChamberPoreMetrics metrics;
    metrics.all = chambers_of(circles.maxima, layer, config);
    metrics.separate = chambers_of(separate, layer, config);
    metrics.disjoint = chambers_of(disjoint, layer, config);
    if (circles.persistent) metrics.persistent = chambers_of(*circles.persistent, layer, config);
    if (metrics.separate.circles.empty()) return metrics;
    const auto [first, last] = std::ranges::minmax(layer.x);
    metrics.n_beyond_data = static_cast<std::size_t>(
        std::ranges::count_if(metrics.separate.circles, [low = first, high = last](const Circle& circle) {
            return circle.x - circle.radius < low || circle.x + circle.radius > high;
        }));
    return metrics;
}

}  // namespace recoat
