#pragma once

#include <vector>

#include "analyzer/fields/map.hpp"

namespace recoat {

/// Distribution and roughness of the surface height. Heights in d_p; fractions of all nodes.
struct HeightMetrics {
    double empty_fraction = 0;            ///< nodes without any sphere over their square
    std::vector<double> bin_upper_edges;  ///< bins (edge - height_bin, edge], up to the highest node
    std::vector<double> fraction;         ///< of the nodes that are not empty, per bin
    double mean = 0, max = 0;
    double roughness = 0;           ///< Ra: mean |h - mean h|, empty nodes as 0
    double roughness_nonempty = 0;  ///< the same over the nodes that are not empty
};

[[nodiscard]] HeightMetrics height_metrics(const Map& height, double bin, double tolerance);

}  // namespace recoat
