#pragma once

#include <cstdint>
#include <vector>

#include "analyzer/fields/pixel_raster.hpp"

namespace recoat {

/// Squared distances in the top view, from the centre of every pixel of some rows to that of the nearest solid pixel of
/// the whole raster, periodic along y; 0 in the solid.
struct PixelDistance {
    std::int64_t begin = 0, rows = 0, columns = 0;  ///< first row, number of rows and columns
    std::vector<std::uint32_t> squared;             ///< [rows][columns] in pixel sides

    [[nodiscard]] std::uint32_t at(std::int64_t row, std::int64_t column) const {
        return squared[static_cast<std::size_t>((row - begin) * columns + column)];
    }
};

/// Rows begin ... end - 1. Memory for these rows and as many beyond as the widest gap of these rows reaches. Distances
/// beyond PixelRaster::farthest are cut off.
[[nodiscard]] PixelDistance pixel_distance(const PixelRaster& raster, std::int64_t begin, std::int64_t end);

}  // namespace recoat
