#pragma once

#include <optional>
#include <stdexcept>
#include <string_view>

namespace recoat {

/// What a quantity measures; its SI unit is that of the parsed value (angles: rad).
enum class Dimension {
    none,
    length,
    time,
    speed,
    acceleration,
    density,
    pressure,
    energy,
    angle,
    angular_velocity,
    force
};

/// A quantity cannot be read; the message says what is wrong and what to write, without a place.
struct UnitError : std::invalid_argument {
    using std::invalid_argument::invalid_argument;
};

/// Value in SI units of a number with a unit, e.g. "50 um" -> 5e-5 for Dimension::length.
///
/// Numbers are written 1e-3, 1.e-3, .5 or 5 alike and are finite. Lengths may be given as multiples of the particle
/// diameter
/// ("1.5 dp") where `particle_diameter` [m] is known. A bare number is accepted for Dimension::none, and for every
/// dimension if it is zero or `plain_is_si`. Throws UnitError.
double parse_quantity(std::string_view text, Dimension dimension, std::optional<double> particle_diameter = {},
                      bool plain_is_si = false);

/// SI unit of a dimension, e.g. "m/s"; empty for Dimension::none.
std::string_view si_unit(Dimension dimension);

/// The word for a dimension in a sentence, e.g. "a length".
std::string_view dimension_name(Dimension dimension);

}  // namespace recoat
