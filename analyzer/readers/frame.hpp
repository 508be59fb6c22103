#pragma once

#include "analyzer/readers/source.hpp"

namespace recoat {

/// Brings particles outside a box that is periodic along x back into it: a place outside is another image. Along y the
/// analysis does the same.
void wrap_along_x(Source& source);

/// Fills in what the analysis needs and the file does not say, as far as the particles and the box show it:
/// particle diameter: the median, to six digits; x_lower, x_upper: smallest and largest x of the centres; y_min,
/// y_period: the box where it is periodic along y; y_lower, y_upper: else the box or the extent of the particles, as a
/// hint; base: the lower end of the box or z = 0, if the lowest particle stands on it within half a diameter, otherwise
/// the bottom of the lowest particle.
void complete_frame(Source& source);

/// Moves the particles so that the base is at z = 0.
void lower_to_base(Source& source, double base);

}  // namespace recoat
