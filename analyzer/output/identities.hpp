#pragma once

#include <cstdint>
#include <vector>

#include "analyzer/readers/source.hpp"

namespace recoat {

/// Identities of the file, or else 1, 2, 3 ...
[[nodiscard]] std::vector<std::int64_t> identities(const Source& source);

}  // namespace recoat
