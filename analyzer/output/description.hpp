#pragma once

#include <string>

#include "analyzer/readers/source.hpp"

namespace recoat {

/// What a file of particles holds, as text for the terminal or as one JSON object.
[[nodiscard]] std::string describe_source(const Source& source, const std::string& file, bool as_json);

}  // namespace recoat
