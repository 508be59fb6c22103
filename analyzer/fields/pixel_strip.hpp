#pragma once

#include <cstdint>
#include <vector>

#include "analyzer/fields/pixel_basins.hpp"

namespace recoat {

/// A row of pixels at the end of a strip: distance, and the top of the strip that a way leads up to, without going
/// below the pixel.
struct PixelBorder {
    std::vector<std::uint32_t> squared, top;  ///< [columns]; the top of solid pixels is PixelBasins::solid
};

/// What remains of a strip of rows when all is settled that does not depend on the rows beyond.
struct PixelStrip {
    std::vector<PixelTop> maxima;   ///< tops known to fall far enough
    std::vector<PixelTop> tops;     ///< tops about which other strips decide
    std::vector<PixelPass> passes;  ///< ways between these
    PixelBorder first, last;        ///< rows; empty at an end of the raster
    bool has_solid = false;
};

/// Merges the basins of a strip from high to low. Of two that meet, the one with the lower top ends: it counts if it
/// has fallen by `height` (pixel sides) or more. One that has touched a border above the level of the meeting may have
/// grown beyond it, so that the meeting is left to be judged with the other strips. `has_before`, `has_after`: whether
/// there are strips on these sides.
[[nodiscard]] PixelStrip pixel_strip(const PixelDistance& pixels, double height, bool has_before, bool has_after);

/// Whether the fall between two squared distances is `height` or more, but for round-off.
[[nodiscard]] bool falls_by(std::uint32_t from_squared, std::uint32_t to_squared, double height);

}  // namespace recoat
