#pragma once

#include <cstdint>
#include <vector>

#include "analyzer/fields/pixel_distance.hpp"

namespace recoat {

/// A set of pixels of equal distance from which no way leads up, within some rows.
struct PixelTop {
    std::uint32_t squared = 0;  ///< distance, squared [pixel sides]
    std::int64_t row = 0;       ///< of one of its pixels
    std::int64_t column = 0;
    std::int64_t count = 0;       ///< pixels
    std::int64_t row_sum = 0;     ///< of their places from that one
    std::int64_t column_sum = 0;  ///< by the shorter way round the period

    /// Joins a set of the same distance that touches this one.
    void absorb(const PixelTop& other, std::int64_t columns);
};

/// A way between two tops, or the basins below them.
struct PixelPass {
    std::uint32_t squared = 0;  ///< least distance on it, squared
    std::uint32_t first = 0, second = 0;

    /// From high to low.
    friend bool operator<(const PixelPass& a, const PixelPass& b) {
        if (a.squared != b.squared) return a.squared > b.squared;
        return a.first != b.first ? a.first < b.first : a.second < b.second;
    }
};

/// Rows of pixels divided into the basins from which the steepest way up leads to the same top; 8 neighbours.
struct PixelBasins {
    static constexpr std::uint32_t solid = 0xFFFFFFFF;

    std::vector<std::uint32_t> basin;  ///< [rows][columns] number of the basin; `solid` for solid pixels
    std::vector<PixelTop> tops;        ///< of each basin
    std::vector<PixelPass> passes;     ///< the highest between any two that touch, and perhaps lower ones
};

[[nodiscard]] PixelBasins pixel_basins(const PixelDistance& pixels);

/// The shorter way round a period.
[[nodiscard]] inline std::int64_t shorter_way(std::int64_t step, std::int64_t period) {
    return 2 * step > period ? step - period : 2 * step < -period ? step + period : step;
}

}  // namespace recoat
