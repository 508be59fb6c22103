#pragma once

#include <compare>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "analyzer/configuration.hpp"
#include "analyzer/fields/layer.hpp"

namespace recoat {

/// A particle in contact, at its image `turn` periods along y. In a short period a particle may touch several images of
/// another, or images of itself.
struct Neighbour {
    std::uint32_t particle = 0;
    std::int32_t turn = 0;

    friend auto operator<=>(const Neighbour&, const Neighbour&) = default;
};

/// Which particles touch: for each the images in contact, by ascending particle and turn.
class ContactGraph {
public:
    ContactGraph() = default;
    ContactGraph(std::vector<std::size_t> start, std::vector<Neighbour> neighbour)
        : start_(std::move(start)), neighbour_(std::move(neighbour)) {}

    [[nodiscard]] std::size_t particles() const { return start_.size() - 1; }
    [[nodiscard]] std::size_t contacts() const { return neighbour_.size() / 2; }
    [[nodiscard]] std::size_t coordination_number(std::size_t particle) const {
        return start_[particle + 1] - start_[particle];
    }
    [[nodiscard]] std::span<const Neighbour> neighbours(std::size_t particle) const {
        return std::span(neighbour_).subspan(start_[particle], coordination_number(particle));
    }

private:
    std::vector<std::size_t> start_ = {0};
    std::vector<Neighbour> neighbour_;
};

/// Pairs whose distance, with any image along y, is less than contact_factor x (r_i + r_j) (or x d_p).
[[nodiscard]] ContactGraph find_contacts(const Layer& layer, const AnalysisConfig& config);

}  // namespace recoat
