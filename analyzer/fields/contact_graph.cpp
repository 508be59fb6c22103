#include "analyzer/fields/contact_graph.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "analyzer/fields/cell_list.hpp"
#include "analyzer/fields/parallel.hpp"

namespace recoat {
namespace {

/// Decides whether two particles touch.
struct Touching {
    const Layer& layer;
    double factor;
    bool by_radii;

    bool operator()(std::size_t i, std::size_t j) const {
        const double reach = factor * (by_radii ? layer.radius[i] + layer.radius[j] : 1.0);
        const double dx = layer.x[i] - layer.x[j];
        const double dy = nearest_image(layer.y[i] - layer.y[j], layer.width);
        const double dz = layer.z[i] - layer.z[j];
        return i != j && dx * dx + dy * dy + dz * dz < reach * reach;
    }

    [[nodiscard]] double longest_reach() const {
        if (!by_radii || layer.size() == 0) return factor;
        return factor * 2 * std::ranges::max(layer.radius);
    }
};

}  // namespace

double nearest_image(double distance, double period) { return distance - period * std::round(distance / period); }

ContactGraph find_contacts(const Layer& layer, const AnalysisConfig& config) {
    const Touching touching{layer, config.contact_factor, config.contact_mode == ContactMode::radii};
    const CellList cells(layer, touching.longest_reach());
    std::vector<std::size_t> start(layer.size() + 1, 0);
    for_each_in_parallel(layer.size(), [&](std::size_t i) {
        cells.for_each_near(i, [&](std::size_t j) { start[i + 1] += touching(i, j); });
    });
    std::partial_sum(start.begin(), start.end(), start.begin());
    std::vector<std::size_t> neighbour(start.back());
    for_each_in_parallel(layer.size(), [&](std::size_t i) {
        auto next = neighbour.begin() + static_cast<std::ptrdiff_t>(start[i]);
        const auto first = next;
        cells.for_each_near(i, [&](std::size_t j) {
            if (touching(i, j)) *next++ = j;
        });
        std::sort(first, next);
    });
    return {std::move(start), std::move(neighbour)};
}

}  // namespace recoat
