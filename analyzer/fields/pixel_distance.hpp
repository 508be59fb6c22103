#pragma once

#include <cstdint>
#include <vector>

#include "analyzer/fields/layer.hpp"

namespace recoat {

/// Squared distances in the top view, from the centre of every pixel to that of the nearest solid pixel, periodic along
/// y. Pixels of side d_p / pixels_per_dp, aligned with the region and the period; solid where the centre is in a disk.
struct PixelDistance {
    static constexpr std::int64_t infinite = std::int64_t{1} << 60;  ///< where there is no solid pixel at all

    int i_begin = 0, nx = 0, ny = 0;    ///< first pixel along x, counted from the start of the region; pixels
    std::vector<std::int64_t> squared;  ///< [nx][ny] in pixel sides
};

/// Over the region and `margin` [d_p] beyond its ends.
[[nodiscard]] PixelDistance pixel_distance(const Layer& layer, int pixels_per_dp, double margin);

}  // namespace recoat
