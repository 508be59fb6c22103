#include "common/config_difference.hpp"

#include <algorithm>
#include <optional>
#include <utility>

#include "common/config_node.hpp"

namespace recoat {
namespace {

using Leaf = std::pair<std::string, std::string>;  ///< key and value

void collect(const ConfigNode& node, const std::string& place, std::vector<Leaf>& leaves) {
    const auto below = [&](const std::string& key) { return place.empty() ? key : place + "." + key; };
    for (const auto& [key, value] : node.entries) collect(*value, below(key), leaves);
    for (std::size_t i = 0; i < node.items.size(); ++i) collect(*node.items[i], below(std::to_string(i)), leaves);
    if (node.entries.empty() && node.items.empty()) leaves.emplace_back(place, node.text);
}

std::vector<Leaf> leaves_of(const std::string& text) {
    std::vector<Leaf> leaves;
    collect(*parse_config_tree(text, "configuration"), "", leaves);
    return leaves;
}

std::optional<std::string> value_in(const std::vector<Leaf>& leaves, const std::string& key) {
    const auto found = std::ranges::find(leaves, key, &Leaf::first);
    return found == leaves.end() ? std::nullopt : std::optional(found->second);
}

}  // namespace

std::vector<ConfigDifference> config_differences(const std::string& first, const std::string& second) {
    const std::vector<Leaf> one = leaves_of(first), other = leaves_of(second);
    std::vector<ConfigDifference> differences;
    for (const auto& [key, value] : one) {
        const std::optional<std::string> counterpart = value_in(other, key);
        if (counterpart != value) differences.push_back({key, value, counterpart.value_or("")});
    }
    for (const auto& [key, value] : other) {
        if (!value_in(one, key)) differences.push_back({key, "", value});
    }
    return differences;
}

}  // namespace recoat
