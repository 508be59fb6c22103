#include "analyzer/fields/empty_circles.hpp"

#include <algorithm>

#include "analyzer/fields/coincidence.hpp"
#include "analyzer/fields/persistence.hpp"
#include "analyzer/fields/tangent_circles.hpp"
#include "analyzer/fields/voronoi_graph.hpp"

namespace recoat {
namespace {

std::vector<Circle> without_coincident(const std::vector<Circle>& circles, double period) {
    std::vector<PlanePoint> centres;
    for (const Circle& circle : circles) centres.push_back({circle.x, circle.y});
    const std::vector<std::size_t> first = first_coincident(centres, period, coincidence_tolerance);
    std::vector<Circle> result;
    for (std::size_t i = 0; i < circles.size(); ++i) {
        if (first[i] == i) result.push_back(circles[i]);
    }
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
    result.persistent.emplace();
    const std::vector<double> depth = persistence(graph, first.x, last.x);
    for (std::size_t i = 0; i < depth.size(); ++i) {
        if (depth[i] > 0) result.persistent->push_back({graph.vertices[i], depth[i]});
    }
    std::ranges::stable_sort(*result.persistent, comes_first, &PersistentCircle::circle);
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
    result.maxima = without_coincident(result.maxima, view.period);
    std::ranges::stable_sort(result.maxima, comes_first);
    return result;
}

}  // namespace recoat
