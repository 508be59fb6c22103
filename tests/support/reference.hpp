#pragma once

#include <fstream>
#include <string>

#include <nlohmann/json.hpp>

namespace recoat::testing {

/// Number `name` of tests/analytic/reference.json; throws std::out_of_range when there is none.
inline double reference(const std::string& name) {
    static const nlohmann::json table = nlohmann::json::parse(std::ifstream(RECOAT_REFERENCE));
    return table.at(name).get<double>();
}

}  // namespace recoat::testing
