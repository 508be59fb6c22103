#pragma once

#include <vector>

#include "analyzer/fields/contact_graph.hpp"
#include "analyzer/fields/layer.hpp"

namespace recoat {

/// Contacts with particles, images along y among them. Counts, fractions and the mean are over the particles of the
/// region.
struct CoordinationMetrics {
    std::size_t n_particles = 0;         ///< in the region
    std::size_t n_contacts = 0;          ///< pairs of the whole file
    double cn_mean = 0;                  ///< [-]
    std::vector<std::size_t> cn_counts;  ///< particles with coordination number 0, 1, ... up to the largest
    std::vector<double> cn_fraction;     ///< the same as shares
};

[[nodiscard]] CoordinationMetrics coordination_metrics(const Layer& layer, const ContactGraph& graph);

/// counts[k] / total for every k; 0 where the total is 0.
[[nodiscard]] std::vector<double> shares(const std::vector<std::size_t>& counts, std::size_t total);

}  // namespace recoat
