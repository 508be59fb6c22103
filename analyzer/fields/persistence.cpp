#include "analyzer/fields/persistence.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <tuple>

#include "analyzer/fields/sort_in_pieces.hpp"

namespace recoat {
namespace {

/// A way between two basins.
struct Pass {
    double throat;
    std::uint32_t first, second;
};

/// Vertices whose widest way leads up at once belong to the basin of the one they lead to: most of a graph. What is
/// left is small enough to be merged in the order of the throats, wherever they lie.
class Basins {
public:
    Basins(const VoronoiGraph& graph, double x_min, double x_max)
        : graph_(graph), x_min_(x_min), x_max_(x_max), up_(graph.vertices.size()) {
        std::iota(up_.begin(), up_.end(), std::size_t{0});
        for (const VoronoiEdge& edge : graph.edges) {
            if (!leads(edge)) continue;
            climb(edge.first, edge.second, edge.throat);
            climb(edge.second, edge.first, edge.throat);
        }
        basin_.assign(graph.vertices.size(), 0);
        for (std::size_t i = 0; i < graph.vertices.size(); ++i) {
            if (up_[i] != i || !counts(i)) continue;
            basin_[i] = static_cast<std::uint32_t>(tops_.size());
            tops_.push_back(i);
        }
        for (std::size_t i = 0; i < graph.vertices.size(); ++i) basin_[i] = basin_[top_of(i)];
    }

    [[nodiscard]] const std::vector<std::size_t>& tops() const { return tops_; }

    /// From wide to narrow.
    [[nodiscard]] std::vector<Pass> passes() const {
        std::vector<Pass> result;
        for (const VoronoiEdge& edge : graph_.edges) {
            const std::uint32_t a = basin_[edge.first], b = basin_[edge.second];
            if (leads(edge) && a != b) result.push_back({edge.throat, std::min(a, b), std::max(a, b)});
        }
        sort_in_pieces(
            result, [](const Pass& pass) { return -pass.throat; },
            [](const Pass& a, const Pass& b) {
                return a.throat != b.throat ? a.throat > b.throat
                                            : std::tie(a.first, a.second) < std::tie(b.first, b.second);
            });
        return result;
    }

private:
    [[nodiscard]] bool counts(std::size_t i) const {
        return graph_.vertices[i].x >= x_min_ && graph_.vertices[i].x <= x_max_;
    }
    [[nodiscard]] bool leads(const VoronoiEdge& edge) const {
        return edge.throat > 0 && counts(edge.first) && counts(edge.second);
    }
    void climb(std::size_t from, std::size_t to, double throat) {
        const std::vector<Circle>& vertices = graph_.vertices;
        if (throat == vertices[from].radius && comes_first(vertices[to], vertices[from])) up_[from] = to;
    }
    std::size_t top_of(std::size_t i) {
        while (up_[i] != i) i = up_[i] = up_[up_[i]];
        return i;
    }

    const VoronoiGraph& graph_;
    double x_min_, x_max_;
    std::vector<std::size_t> up_;
    std::vector<std::size_t> tops_;
    std::vector<std::uint32_t> basin_;
};

}  // namespace

std::vector<double> persistence(const VoronoiGraph& graph, double x_min, double x_max) {
    const Basins basins(graph, x_min, x_max);
    const std::vector<std::size_t>& tops = basins.tops();
    std::vector<Circle> top(tops.size());
    std::vector<double> depth(tops.size());
    for (std::size_t k = 0; k < tops.size(); ++k) {
        top[k] = graph.vertices[tops[k]];
        depth[k] = std::max(top[k].radius, 0.0);
    }
    std::vector<std::uint32_t> parent(tops.size());
    std::iota(parent.begin(), parent.end(), std::uint32_t{0});
    const auto find = [&](std::uint32_t i) {
        while (parent[i] != i) i = parent[i] = parent[parent[i]];
        return i;
    };
    // The root of a set is its largest vertex. From wide to narrow, each way ends the smaller of the sets it joins.
    for (const Pass& pass : basins.passes()) {
        std::uint32_t elder = find(pass.first), younger = find(pass.second);
        if (elder == younger) continue;
        if (comes_first(top[younger], top[elder])) std::swap(elder, younger);
        parent[younger] = elder;
        depth[younger] = std::max(top[younger].radius - pass.throat, 0.0);
    }
    std::vector<double> result(graph.vertices.size(), 0);
    for (std::size_t k = 0; k < tops.size(); ++k) result[tops[k]] = depth[k];
    return result;
}

}  // namespace recoat
