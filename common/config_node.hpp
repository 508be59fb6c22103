#pragma once

#include <cstddef>
#include <memory>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace recoat {

/// A value of a configuration file with its place, and what has been asked of it.
struct ConfigNode {
    enum class Kind { null, scalar, list, mapping };
    using Pointer = std::shared_ptr<ConfigNode>;

    Kind kind = Kind::null;
    std::string text;           ///< scalar as written, without quotes
    bool quoted = false;        ///< scalar in quotes, kept for writing it back
    std::size_t line = 0;       ///< of the key, or of the value in a list; from 1
    std::string override_text;  ///< "a.b=v" where the value came from the command line
    std::string option;         ///< "--name value" where it came from an option of its own

    std::vector<Pointer> items;                            ///< list
    std::vector<std::pair<std::string, Pointer>> entries;  ///< mapping, in the order of the file

    std::set<std::string, std::less<>> asked;                   ///< keys that the program knows
    std::set<std::string, std::less<>> used;                    ///< keys whose value was taken
    std::vector<std::pair<std::string, std::string>> defaults;  ///< values that stood in for absent keys

    [[nodiscard]] Pointer find(std::string_view key) const;
};

/// Tree of the YAML (or JSON) `text`; `name` stands for the file in errors. Throws InputError on a syntax error, a key
/// given twice, or when the document is not a mapping.
ConfigNode::Pointer parse_config_tree(const std::string& text, const std::string& name);

/// Puts the values of "a.b=v" in place, making mappings that are absent. A part of the path may be the index of a list
/// item or the only key of one. Throws InputError.
void apply_overrides(ConfigNode& root, std::span<const std::string> overrides);

/// The tree as YAML text, with the defaults that were used.
std::string to_yaml(const ConfigNode& node);

}  // namespace recoat
