#pragma once

#include "analyzer/readers/source.hpp"
#include "common/config.hpp"

namespace recoat {

/// What the region along x is measured in [m].
struct RegionScale {
    double diameter = 0;  ///< d_p
    double cell = 0;      ///< nominal side of a cell
    double window = 0;    ///< nominal side of the window of the packing density
};

/// The region along x [m].
struct Region {
    double begin = 0, end = 0;
};

/// Region along x: `x_range`; or the way of the blade without `skip_start` and `skip_end` [paper section 3]; or the
/// extent of the particles, one diameter in from its ends. The last two are shortened to whole cells.
/// @throws InputError when nothing is left, when it ends before it begins, or when `x_range` reaches more than a few
/// windows beyond the particles (and the way of the blade, where it is known).
[[nodiscard]] Region read_region(const Config& config, const SourceInfo& info, const RegionScale& scale);

}  // namespace recoat
