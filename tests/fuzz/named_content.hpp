#pragma once

#include "analyzer/readers/content.hpp"

namespace recoat::fuzz {

/// Loads files that an input names, without the disk: "a.vtu", "b.csv", "c.pvtu" and "d.pvd" are there, nothing else.
[[nodiscard]] Content load_named(const std::filesystem::path& file);

}  // namespace recoat::fuzz
