#pragma once

#include <string>

namespace recoat {

/// How the configuration `there` (of the run in a folder) and `here` (of the run asked for) differ, as part of a
/// sentence: "blade.speed is 50 mm/s there and 60 mm/s here; ...". Both are resolved configurations; empty when they
/// are the same.
std::string configuration_differences(const std::string& there, const std::string& here);

}  // namespace recoat
