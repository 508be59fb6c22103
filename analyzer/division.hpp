#pragma once

#include <algorithm>
#include <cmath>

namespace recoat {

/// How a length is cut into equal parts.
struct Division {
    double count = 1;    ///< number of parts, whole
    double stretch = 1;  ///< side of a part over the side that was asked for
};

/// Parts that are out by less than this share of one fit as they are: round-off of a period or of its limits.
inline constexpr double fits_within = 1e-6;

[[nodiscard]] inline bool is_whole(double value) { return std::abs(value - std::round(value)) <= fits_within; }

/// Parts as near to a nominal side as fit into `length` a whole number of times; at least one. The stretch is exactly 1
/// where the nominal side fits.
/// @param sides length over the nominal side, not negative
[[nodiscard]] inline Division divide(double sides) {
    const double count = std::max(1.0, std::round(sides));
    return {count, is_whole(sides) && sides >= 0.5 ? 1.0 : sides / count};
}

}  // namespace recoat
