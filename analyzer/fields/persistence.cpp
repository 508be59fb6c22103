#include "analyzer/fields/persistence.hpp"

#include <algorithm>
#include <cstddef>
#include <numeric>

namespace recoat {

std::vector<double> persistence(const VoronoiGraph& graph, double x_min, double x_max) {
    const std::vector<Circle>& vertices = graph.vertices;
    const auto counts = [&](std::size_t i) { return vertices[i].x >= x_min && vertices[i].x <= x_max; };
    std::vector<std::size_t> parent(vertices.size());
    std::iota(parent.begin(), parent.end(), std::size_t{0});
    const auto find = [&](std::size_t i) {
        while (parent[i] != i) i = parent[i] = parent[parent[i]];
        return i;
    };
    // The root of a set is its largest vertex. From wide to narrow, each way ends the smaller of the sets that it
    // joins.
    std::vector<std::size_t> order;
    for (std::size_t e = 0; e < graph.edges.size(); ++e) {
        const VoronoiEdge& edge = graph.edges[e];
        if (edge.throat > 0 && counts(edge.first) && counts(edge.second)) order.push_back(e);
    }
    std::ranges::sort(order, [&](std::size_t a, std::size_t b) {
        const double wide = graph.edges[a].throat, other = graph.edges[b].throat;
        return wide != other ? wide > other : a < b;
    });
    std::vector<double> result(vertices.size());
    for (std::size_t i = 0; i < vertices.size(); ++i) result[i] = counts(i) ? std::max(vertices[i].radius, 0.0) : 0;
    for (const std::size_t e : order) {
        std::size_t elder = find(graph.edges[e].first), younger = find(graph.edges[e].second);
        if (elder == younger) continue;
        if (comes_first(vertices[younger], vertices[elder])) std::swap(elder, younger);
        parent[younger] = elder;
        result[younger] = std::max(vertices[younger].radius - graph.edges[e].throat, 0.0);
    }
    return result;
}

}  // namespace recoat
