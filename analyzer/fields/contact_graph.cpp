#include "analyzer/fields/contact_graph.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "analyzer/fields/cell_list.hpp"
#include "analyzer/fields/parallel.hpp"

namespace recoat {
namespace {

/// Finds the images of a particle that another touches.
class Touching {
public:
    Touching(const Layer& layer, const AnalysisConfig& config)
        : layer_(layer), factor_(config.contact_factor), by_radii_(config.contact_mode == ContactMode::radii) {
        const double largest = by_radii_ && layer.size() > 0 ? 2 * std::ranges::max(layer.radius) : 1;
        longest_reach_ = factor_ * largest;
        // Where half a period is farther than any contact, only the nearest image can touch.
        nearest_only_ = layer.width >= 2 * longest_reach_;
    }

    [[nodiscard]] double longest_reach() const { return longest_reach_; }

    /// visit(neighbour) for every image of j that i touches.
    template <class Visit>
    void for_each_image(std::size_t i, std::size_t j, Visit visit) const {
        const double reach = factor_ * (by_radii_ ? layer_.radius[i] + layer_.radius[j] : 1.0);
        const double dx = layer_.x[j] - layer_.x[i], dy = layer_.y[j] - layer_.y[i], dz = layer_.z[j] - layer_.z[i];
        const double width = layer_.width, beside = dx * dx + dz * dz;
        if (!(beside < reach * reach)) return;
        const double nearest = -std::round(dy / width);
        const double more = nearest_only_ ? 0 : std::ceil(reach / width);
        for (double turn = nearest - more; turn <= nearest + more; ++turn) {
            const double distance = dy + turn * width;
            const bool itself = i == j && turn == 0;
            if (!itself && beside + distance * distance < reach * reach)
                visit({static_cast<std::uint32_t>(j), static_cast<std::int32_t>(turn)});
        }
    }

private:
    const Layer& layer_;
    double factor_, longest_reach_ = 0;
    bool by_radii_, nearest_only_ = true;
};

}  // namespace

ContactGraph find_contacts(const Layer& layer, const AnalysisConfig& config) {
    const Touching touching(layer, config);
    const CellList cells(layer, touching.longest_reach());
    std::vector<std::size_t> start(layer.size() + 1, 0);
    for_each_in_parallel(layer.size(), [&](std::size_t i) {
        cells.for_each_near(i,
                            [&](std::size_t j) { touching.for_each_image(i, j, [&](Neighbour) { ++start[i + 1]; }); });
    });
    std::partial_sum(start.begin(), start.end(), start.begin());
    std::vector<Neighbour> neighbour(start.back());
    for_each_in_parallel(layer.size(), [&](std::size_t i) {
        auto next = neighbour.begin() + static_cast<std::ptrdiff_t>(start[i]);
        const auto first = next;
        cells.for_each_near(
            i, [&](std::size_t j) { touching.for_each_image(i, j, [&](Neighbour found) { *next++ = found; }); });
        std::sort(first, next);
    });
    return {std::move(start), std::move(neighbour)};
}

}  // namespace recoat
