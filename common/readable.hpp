#pragma once

#include <string>
#include <string_view>

namespace recoat {

/// A quantity as a person reads it: three to four digits and the prefix that keeps it between 1 and 1000, e.g.
/// (5e-5, "m") -> "50 um", (6.04e10, "Pa") -> "60.4 GPa", (2.9e-10, "kg") -> "290 ng". Beyond the prefixes from atto to
/// tera, and for units other than m, s, g, N, J and Pa, the number keeps its exponent.
std::string readable(double value, std::string_view unit);

/// A speed [m/s] in the same way: "50 mm/s".
std::string readable_speed(double speed);

/// A time that passes, to two or three digits in the unit that suits it: "2.2 us", "0.22 ms", "12 s", "3.5 min",
/// "2.1 h", "16 days"; `seconds` may be infinite ("for ever").
std::string readable_duration(double seconds);

/// A size in powers of 1024: "812 bytes", "1.4 MiB".
std::string readable_bytes(double bytes);

/// A whole number with its thousands apart, e.g. "25 075 000".
std::string readable_count(long long count);

}  // namespace recoat
