#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "analyzer/readers/source.hpp"

namespace recoat {

/// Numbers of the types, by their place in type.names: as the file has them, or nothing when one is a word.
[[nodiscard]] std::optional<std::vector<std::int64_t>> type_numbers(const Source& source);

}  // namespace recoat
