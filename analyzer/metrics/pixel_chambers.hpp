#pragma once

#include <vector>

#include "analyzer/configuration.hpp"
#include "analyzer/fields/layer.hpp"
#include "analyzer/fields/top_view.hpp"
#include "analyzer/metrics/pore_sizes.hpp"

namespace recoat {

/// Chamber pores measured in pixels.
struct PixelChambers {
    PoreSizes sizes;
    std::vector<Circle> circles;  ///< from large to small, from the start of the region and y_min [d_p]
};

/// The pixel form of the chamber pores by rule P: h-maxima, by chamber_persistence, of the distance transform of the
/// top view in square pixels of the side of the voxels along y; size = twice the distance from pixel centre to solid
/// pixel centre [d_p].
[[nodiscard]] PixelChambers pixel_chambers(const Layer& layer, const AnalysisConfig& config, int pixels_per_dp);

}  // namespace recoat
