#pragma once

#include <string>
#include <vector>

namespace recoat {

/// A key that two configurations do not share, or whose values differ.
struct ConfigDifference {
    std::string key;            ///< e.g. "stages.2.spread.length"
    std::string first, second;  ///< values as written; empty where the key is absent
};

/// Where two configurations (YAML) differ, keys of the first in its order, then those that only the second has. Throws
/// InputError on a syntax error.
std::vector<ConfigDifference> config_differences(const std::string& first, const std::string& second);

}  // namespace recoat
