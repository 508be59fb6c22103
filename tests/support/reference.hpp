#pragma once

#include <cstdlib>
#include <fstream>
#include <string>

#include <nlohmann/json.hpp>

namespace recoat::testing {

/// Number `name` of tests/analytic/reference.json, or of the file that RECOAT_REFERENCE names where the tests were
/// built on another machine; throws std::out_of_range when there is none.
inline double reference(const std::string& name) {
    const char* elsewhere = std::getenv("RECOAT_REFERENCE");
    static const nlohmann::json table =
        nlohmann::json::parse(std::ifstream(elsewhere != nullptr ? elsewhere : RECOAT_REFERENCE));
    return table.at(name).get<double>();
}

}  // namespace recoat::testing
