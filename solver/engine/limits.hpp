#pragma once

#include <cstdint>

namespace recoat::limits {

/// Overlap beyond which a run stops, in radii of the smallest particle: no contact law holds there.
inline constexpr double overlap = 0.25;

/// Way per step beyond which a run stops, in radii of the smallest particle: contacts would be jumped over.
inline constexpr double travel_per_step = 0.05;

/// Limits of the close list's margin, in d_p.
inline constexpr double least_margin = 0.003;
inline constexpr double most_margin = 0.02;

/// Steps after which a copy of everything is kept, from which a fault steps forward to the moment before it.
inline constexpr std::int64_t steps_per_copy = 2000;

}  // namespace recoat::limits
