#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "common/config_node.hpp"

namespace recoat {

/// Number of insertions, deletions, replacements and swaps of neighbours that turn one word into the other.
std::size_t edit_distance(std::string_view a, std::string_view b);

/// The word that is spelt like `wanted`, a third of whose letters may differ; empty when there is none.
std::string closest_word(const std::vector<std::string>& words, std::string_view wanted);

/// The key of `node` that was never asked for and is spelt like `wanted`; empty when there is none.
std::string closest_unknown(const ConfigNode& node, std::string_view wanted);

/// The key that was asked of `node` and is spelt like `unknown`; empty when there is none.
std::string closest_known(const ConfigNode& node, std::string_view unknown);

}  // namespace recoat
