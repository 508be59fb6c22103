#pragma once

#include "analyzer/configuration.hpp"
#include "analyzer/fields/layer.hpp"
#include "analyzer/fields/map.hpp"

namespace recoat {

/// Surface height at every node [d_p], index [ix][iy]: the highest point of any sphere over the window of nominal side
/// `height_window` around it, 0 where there is none.
[[nodiscard]] Map height_map(const Layer& layer, const AnalysisConfig& config);

}  // namespace recoat
