#pragma once

#include "analyzer/configuration.hpp"
#include "analyzer/fields/layer.hpp"
#include "analyzer/metrics/pore_sizes.hpp"

namespace recoat {

/// The pixel form of the chamber pores by rule P: h-maxima, by chamber_persistence, of the distance transform of the
/// top view; size = twice the distance from pixel centre to solid pixel centre [d_p].
[[nodiscard]] PoreSizes pixel_chamber_sizes(const Layer& layer, const AnalysisConfig& config, int pixels_per_dp);

}  // namespace recoat
