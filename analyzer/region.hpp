#pragma once

#include "analyzer/readers/source.hpp"
#include "common/config.hpp"

namespace recoat {

/// What the region along x is measured in [m].
struct RegionScale {
    double diameter = 0;  ///< d_p
    double cell = 0;      ///< nominal side of a cell
};

/// The region along x [m].
struct Region {
    double begin = 0, end = 0;
};

/// Region along x: `x_range`; or the way of the blade without `skip_start` and `skip_end` [paper section 3]; or the
/// extent of the particles, one diameter in from its ends. The last two are shortened to whole cells.
/// @throws InputError when nothing is left, or when it ends before it begins.
[[nodiscard]] Region read_region(const Config& config, const SourceInfo& info, const RegionScale& scale);

/// What is typed must not decide how long an analysis takes.
/// @param window side of the window of the packing density [m]
/// @throws InputError when `x_range` reaches more than a few windows beyond the particles (and the way of the blade,
/// where it is known).
void check_reach(const Config& config, const SourceInfo& info, const Region& region, double window);

}  // namespace recoat
