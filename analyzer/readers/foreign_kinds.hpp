#pragma once

#include <optional>
#include <string>

#include "analyzer/readers/content.hpp"

namespace recoat {

/// What a file is that holds no list of particles, or holds it in a form that is not read, and what to do instead, e.g.
/// "this is a zip archive; unpack it and give the file in it"; nothing for anything else.
[[nodiscard]] std::optional<std::string> foreign_kind(const Content& content);

}  // namespace recoat
