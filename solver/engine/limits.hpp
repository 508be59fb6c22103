#pragma once

#include <cstdint>

namespace recoat::limits {

/// Overlap beyond which a run stops, in radii of the smallest particle: no contact law holds there.
inline constexpr double overlap = 0.25;

/// Way per step beyond which a run stops, in radii of the smallest particle: contacts would be jumped over.
inline constexpr double travel_per_step = 0.05;

/// Skin of the far list, in d_p.
inline constexpr double far_skin = 0.1;

/// Limits of the close list's margin, in d_p, and the steps it should last.
inline constexpr double least_margin = 0.003;
inline constexpr double most_margin = 0.02;
inline constexpr double steps_per_close_list = 100;

/// Steps after which a copy of everything is kept, from which a fault steps forward to the moment before it.
inline constexpr std::int64_t steps_per_copy = 2000;

}  // namespace recoat::limits
