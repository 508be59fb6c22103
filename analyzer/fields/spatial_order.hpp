#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "analyzer/fields/clusters.hpp"
#include "analyzer/fields/contact_graph.hpp"
#include "analyzer/fields/layer.hpp"

namespace recoat {

/// An order of the particles of a layer in which neighbours are near in memory: along x in columns of boxes, along y
/// within. Work that goes from particle to neighbour takes several times as long in the order of a file that has been
/// stirred, once the layer no longer fits the cache.
class SpatialOrder {
public:
    explicit SpatialOrder(const Layer& layer);

    /// The layer in this order.
    [[nodiscard]] Layer apply(const Layer& layer) const;

    /// What has been found for the layer in this order, with the numbers of the layer itself.
    [[nodiscard]] std::vector<std::uint32_t> coordination_numbers(const ContactGraph& graph) const;
    [[nodiscard]] Clusters restore(const Clusters& clusters) const;

private:
    std::vector<std::size_t> particle_;  ///< [place]
    std::vector<std::size_t> place_;     ///< [particle]
};

}  // namespace recoat
