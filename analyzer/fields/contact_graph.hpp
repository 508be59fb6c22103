#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "analyzer/configuration.hpp"
#include "analyzer/fields/layer.hpp"

namespace recoat {

/// Which particles touch: for each the others in contact, in ascending order.
class ContactGraph {
public:
    ContactGraph() = default;
    ContactGraph(std::vector<std::size_t> start, std::vector<std::size_t> neighbour)
        : start_(std::move(start)), neighbour_(std::move(neighbour)) {}

    [[nodiscard]] std::size_t particles() const { return start_.size() - 1; }
    [[nodiscard]] std::size_t contacts() const { return neighbour_.size() / 2; }
    [[nodiscard]] std::size_t coordination_number(std::size_t particle) const {
        return start_[particle + 1] - start_[particle];
    }
    [[nodiscard]] std::span<const std::size_t> neighbours(std::size_t particle) const {
        return std::span(neighbour_).subspan(start_[particle], coordination_number(particle));
    }

private:
    std::vector<std::size_t> start_ = {0};
    std::vector<std::size_t> neighbour_;
};

/// Pairs whose distance, with the nearest image along y, is less than contact_factor x d_p (or x (r_i + r_j)).
[[nodiscard]] ContactGraph find_contacts(const Layer& layer, const AnalysisConfig& config);

/// y distance brought to the nearest image.
[[nodiscard]] double nearest_image(double distance, double period);

}  // namespace recoat
