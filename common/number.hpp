#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace recoat {

/// Value of a decimal number (1e-3, 1.e-3, .5, +2, inf, nan), or nothing when `text` is anything else. Ignores the
/// locale.
std::optional<double> parse_number(std::string_view text);

/// Value of a whole number ("42", "-7", "+3"), or nothing.
std::optional<std::int64_t> parse_integer(std::string_view text);

/// `text` without white space at both ends.
std::string_view trimmed(std::string_view text);

/// The shortest text that reads back as the same double, e.g. "5e-05".
std::string shortest(double value);

}  // namespace recoat
