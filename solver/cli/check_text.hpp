#pragma once

#include <string>

#include <nlohmann/json.hpp>

namespace recoat {

/// The report of `recoat-solve check` as text for a person, in units with prefixes.
std::string check_text(const nlohmann::ordered_json& report);

}  // namespace recoat
