#pragma once

#include <filesystem>

#include "analyzer/readers/source.hpp"

namespace recoat {

/// Writes particles as vertices of a VTP file with the arrays Radius and Id (where they have one): doubles, appended as
/// they are in memory.
void write_vtp(const std::filesystem::path& place, const Source& source);

}  // namespace recoat
