#pragma once

#include <vector>

#include "analyzer/fields/pixel_raster.hpp"

namespace recoat {

/// A connected set of pixels of equal distance that is higher than all around it.
struct PixelMaximum {
    double row = 0, column = 0;  ///< mean place of its pixels, unwrapped along y from one of them
    double distance = 0;         ///< in pixel sides
};

/// h-maxima of the distances: those from which the distance falls by `height` (in pixel sides) or more on every way to
/// a larger one, or to the solid. Neighbours across corners count, periodic along y. From large to small. None in a
/// raster without solid pixels.
///
/// Strips of `strip_rows` rows are worked on one by one: what falls by less, or ends, within a strip is settled there.
/// Memory for a strip per thread, and for what remains of all of them; 0 rows: as many as make a good size.
[[nodiscard]] std::vector<PixelMaximum> pixel_maxima(const PixelRaster& raster, double height,
                                                     std::int64_t strip_rows = 0);

}  // namespace recoat
