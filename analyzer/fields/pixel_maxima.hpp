#pragma once

#include <vector>

#include "analyzer/fields/pixel_distance.hpp"

namespace recoat {

/// A connected set of pixels of equal distance that is higher than all around it.
struct PixelMaximum {
    double i = 0;         ///< mean place of its pixels along x, from the first of the map
    double distance = 0;  ///< in pixel sides
};

/// h-maxima of the distances: those from which the distance falls by `height` (in pixel sides) or more on every way to
/// a larger one, or to the solid. Neighbours across corners count, periodic along y.
[[nodiscard]] std::vector<PixelMaximum> pixel_maxima(const PixelDistance& pixels, double height);

}  // namespace recoat
