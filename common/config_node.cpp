#include "common/config_node.hpp"

#include <algorithm>

#include <fmt/format.h>
#include <yaml-cpp/yaml.h>

#include "common/error.hpp"
#include "common/number.hpp"
#include "common/text_encoding.hpp"

namespace recoat {
namespace {

using Kind = ConfigNode::Kind;
using Pointer = ConfigNode::Pointer;

// Deeper files are no configurations; the limit also ends documents that contain themselves through an alias.
constexpr int deepest_nesting = 32;

[[noreturn]] void fail_at(const std::string& name, std::size_t line, const std::string& problem) {
    throw InputError(fmt::format("{}:{}: {}", name, line, problem));
}

std::size_t line_of(const YAML::Node& node) { return static_cast<std::size_t>(node.Mark().line) + 1; }

Pointer convert(const YAML::Node& source, const std::string& name, std::size_t line, int depth) {
    if (depth > deepest_nesting) fail_at(name, line, "the values are nested too deeply; simplify the file");
    auto node = std::make_shared<ConfigNode>();
    node->line = line;
    if (source.IsScalar()) {
        node->kind = Kind::scalar;
        node->text = source.Scalar();
        node->quoted = source.Tag() == "!";
    } else if (source.IsSequence()) {
        node->kind = Kind::list;
        for (const auto& item : source) node->items.push_back(convert(item, name, line_of(item), depth + 1));
    } else if (source.IsMap()) {
        node->kind = Kind::mapping;
        for (const auto& entry : source) {
            const std::size_t key_line = line_of(entry.first);
            if (!entry.first.IsScalar()) fail_at(name, key_line, "a key is not a plain word; write \"key: value\"");
            const std::string key = entry.first.Scalar();
            if (const Pointer first = node->find(key)) {
                fail_at(
                    name, key_line,
                    fmt::format("{}: the key was given before, on line {}; remove one of the two", key, first->line));
            }
            node->entries.emplace_back(key, convert(entry.second, name, key_line, depth + 1));
        }
    }
    return node;
}

/// Parses YAML, in Latin-1 too, as editors of Windows may save it, or calls `refuse(line, message of the parser)`,
/// which throws.
template <class Refuse>
YAML::Node load(const std::string& text, const Refuse& refuse) {
    try {
        return YAML::Load(wide_encoding(text).empty() ? in_utf8(text) : text);
    } catch (const YAML::Exception& error) {
        refuse(static_cast<std::size_t>(error.mark.line) + 1, error.msg);
        throw;
    }
}

void mark_as_override(ConfigNode& node, const std::string& text) {
    node.override_text = text;
    for (const Pointer& item : node.items) mark_as_override(*item, text);
    for (const auto& [key, value] : node.entries) mark_as_override(*value, text);
}

[[noreturn]] void fail_override(const std::string& text, const std::string& problem) {
    throw InputError(fmt::format("--set {}: {}", text, problem));
}

/// Item of a list by its index, or by its only key ("stages.spread"): the place to go on from. `part` is consumed only
/// in the first case.
Pointer list_item(const ConfigNode& list, std::string_view part, const std::string& text, bool& consumed) {
    if (const auto index = parse_integer(part)) {
        if (*index < 0 || static_cast<std::size_t>(*index) >= list.items.size()) {
            fail_override(text,
                          fmt::format("the list has no item {}; it has {}, counted from 0", part, list.items.size()));
        }
        consumed = true;
        return list.items[static_cast<std::size_t>(*index)];
    }
    Pointer found;
    for (const Pointer& item : list.items) {
        if (!item->find(part) && !(item->kind == Kind::scalar && item->text == part)) continue;
        if (found)
            fail_override(text, fmt::format("several items of the list are called {}; give the index instead", part));
        found = item;
    }
    if (!found)
        fail_override(text, fmt::format("no item of the list is called {}; give the index, counted from 0", part));
    consumed = false;
    return found;
}

/// A null becomes an empty mapping, and a word in a list ("- heap") the mapping of that word to nothing.
void make_mapping(ConfigNode& node, const std::string& text, std::string_view part) {
    if (node.kind == Kind::mapping) return;
    if (node.kind == Kind::scalar && node.text == part) {
        node.entries.emplace_back(node.text, std::make_shared<ConfigNode>());
    } else if (node.kind != Kind::null) {
        fail_override(text, fmt::format("{} is below a plain value, which has no keys; shorten the path", part));
    }
    node.kind = Kind::mapping;
    node.text.clear();
}

void apply_override(ConfigNode& root, const std::string& text) {
    const auto equals = text.find('=');
    if (equals == std::string::npos || equals == 0) fail_override(text, "this has no form; write key.key=value");
    const auto document = load(text.substr(equals + 1), [&](std::size_t, const std::string& message) {
        fail_override(text, fmt::format("the value is not valid YAML ({}); check its quotes and brackets", message));
    });
    const Pointer value = convert(document, "--set " + text, 1, 0);
    mark_as_override(*value, text);

    std::string_view rest = std::string_view(text).substr(0, equals);
    ConfigNode* node = &root;
    Pointer* place = nullptr;
    while (!rest.empty()) {
        const auto dot = rest.find('.');
        const std::string_view part = rest.substr(0, dot);
        if (part.empty()) fail_override(text, "a part of the key is empty; write key.key=value");
        bool consumed = true;
        if (node->kind == Kind::list) {
            Pointer item = list_item(*node, part, text, consumed);
            place = &*std::find(node->items.begin(), node->items.end(), item);
        } else {
            make_mapping(*node, text, part);
            auto entry = std::find_if(node->entries.begin(), node->entries.end(),
                                      [&](const auto& e) { return e.first == part; });
            if (entry == node->entries.end()) {
                auto fresh = std::make_shared<ConfigNode>();
                fresh->override_text = text;
                entry = node->entries.insert(entry, {std::string(part), fresh});
            }
            place = &entry->second;
        }
        node = place->get();
        if (consumed) rest = dot == std::string_view::npos ? std::string_view{} : rest.substr(dot + 1);
    }
    *place = value;
}

void write(YAML::Emitter& out, const ConfigNode& node) {
    switch (node.kind) {
        case Kind::null:
            if (node.defaults.empty()) {
                out << YAML::Null;
                return;
            }
            [[fallthrough]];
        case Kind::mapping:
            out << YAML::BeginMap;
            for (const auto& [key, value] : node.entries) {
                out << YAML::Key << key << YAML::Value;
                write(out, *value);
            }
            for (const auto& [key, text] : node.defaults) out << YAML::Key << key << YAML::Value << text;
            out << YAML::EndMap;
            return;
        case Kind::list:
            out << YAML::BeginSeq;
            for (const Pointer& item : node.items) write(out, *item);
            out << YAML::EndSeq;
            return;
        case Kind::scalar:
            if (node.quoted) out << YAML::DoubleQuoted;
            out << node.text;
            return;
    }
}

}  // namespace

Pointer ConfigNode::find(std::string_view key) const {
    for (const auto& [name, value] : entries) {
        if (name == key) return value;
    }
    return nullptr;
}

Pointer parse_config_tree(const std::string& text, const std::string& name) {
    const auto document = load(text, [&](std::size_t line, const std::string& message) {
        fail_at(name, line,
                fmt::format("the text is not valid YAML ({}); check the indentation, colons and quotes here", message));
    });
    if (!document.IsMap())
        fail_at(name, 1, "the file holds no \"key: value\" pairs at its top; start from a shipped example");
    return convert(document, name, 1, 0);
}

void apply_overrides(ConfigNode& root, std::span<const std::string> overrides) {
    for (const std::string& text : overrides) apply_override(root, text);
}

std::string to_yaml(const ConfigNode& node) {
    YAML::Emitter out;
    write(out, node);
    return std::string(out.c_str()) + "\n";
}

}  // namespace recoat
