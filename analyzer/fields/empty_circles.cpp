#include "analyzer/fields/empty_circles.hpp"

#include <algorithm>

#include "analyzer/fields/coincidence.hpp"
#include "analyzer/fields/persistence.hpp"
#include "analyzer/fields/tangent_circles.hpp"
#include "analyzer/fields/voronoi_graph.hpp"

namespace recoat {
namespace {

/// In their order, circles with the same centre once.
std::vector<Circle> distinct(const std::vector<Circle>& circles, double period) {
    std::vector<PlanePoint> centres;
    centres.reserve(circles.size());
    for (const Circle& circle : circles) centres.push_back({circle.x, circle.y});
    const std::vector<std::size_t> first = first_coincident(centres, period, coincidence_tolerance);
    std::vector<Circle> result;
    for (const std::size_t i : from_large_to_small(circles)) {
        if (first[i] == i) result.push_back(circles[i]);
    }
    return result;
}

std::vector<PersistentCircle> persistent_circles(const VoronoiGraph& graph, double x_min, double x_max) {
    const std::vector<double> depth = persistence(graph, x_min, x_max);
    std::vector<Circle> circles;
    std::vector<double> depths;
    for (std::size_t i = 0; i < depth.size(); ++i) {
        if (depth[i] <= 0) continue;
        circles.push_back(graph.vertices[i]);
        depths.push_back(depth[i]);
    }
    std::vector<PersistentCircle> result;
    result.reserve(circles.size());
    for (const std::size_t i : from_large_to_small(circles)) result.push_back({circles[i], depths[i]});
    return result;
}

EmptyCircles between_equal_disks(const TopView& view) {
    const VoronoiGraph graph = voronoi_graph(view);
    EmptyCircles result;
    for (std::size_t i = 0; i < graph.vertices.size(); ++i) {
        if (graph.is_maximum[i] && graph.vertices[i].radius > 0) result.maxima.push_back(graph.vertices[i]);
    }
    if (view.disks.empty()) return result;
    const auto [first, last] = std::ranges::minmax(view.disks, {}, &Disk::x);
    result.persistent = persistent_circles(graph, first.x, last.x);
    return result;
}

}  // namespace

EmptyCircles empty_circles(const Layer& layer) {
    const TopView view = top_view(layer);
    EmptyCircles result;
    if (view.equal_radii) {
        result = between_equal_disks(view);
    } else {
        result.maxima = tangent_circles(view);
    }
    result.maxima = distinct(result.maxima, view.period);
    return result;
}

}  // namespace recoat
