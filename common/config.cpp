#include "common/config.hpp"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <optional>
#include <sstream>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "common/config_spelling.hpp"
#include "common/error.hpp"
#include "common/number.hpp"
#include "common/readable.hpp"

namespace recoat {

using Kind = ConfigNode::Kind;

/// What all sections of a file share.
struct Config::Document {
    std::string name;
    std::optional<double> particle_diameter;
    bool plain_is_si = false;
};

bool Range::contains(double value) const {
    return (lower_open ? value > lower : value >= lower) && (upper_open ? value < upper : value <= upper);
}

namespace {

std::string describe(const Range& range, Dimension dimension) {
    const auto bound = [&](double value) {
        return dimension == Dimension::none ? shortest(value) : readable(value, si_unit(dimension));
    };
    std::vector<std::string> bounds;
    if (std::isfinite(range.lower))
        bounds.push_back((range.lower_open ? "greater than " : "at least ") + bound(range.lower));
    if (std::isfinite(range.upper))
        bounds.push_back((range.upper_open ? "less than " : "at most ") + bound(range.upper));
    return bounds.empty() ? "finite" : fmt::format("{}", fmt::join(bounds, " and "));
}

std::string quantity_text(double value, Dimension dimension) {
    const auto unit = si_unit(dimension);
    return unit.empty() ? shortest(value) : fmt::format("{} {}", shortest(value), unit);
}

std::string wanted_quantity(Dimension dimension) {
    if (dimension == Dimension::none) return "a plain number";
    return fmt::format("{} with a unit, as in \"1 {}\"", dimension_name(dimension), si_unit(dimension));
}

std::string list_text(std::span<const std::string_view> words) { return fmt::format("{}", fmt::join(words, ", ")); }

}  // namespace

Config::Config(std::shared_ptr<Document> document, ConfigNode::Pointer node, std::string path)
    : document_(std::move(document)), node_(std::move(node)), path_(std::move(path)) {}

Config Config::load(const std::filesystem::path& file, std::span<const std::string> overrides) {
    std::ifstream stream(file, std::ios::binary);
    std::ostringstream text;
    if (!stream || std::filesystem::is_directory(file) || !(text << stream.rdbuf())) {
        throw InputError(
            fmt::format("{}: the file cannot be read or is empty; check its name and permissions", file.string()));
    }
    return parse(text.str(), file.string(), overrides);
}

Config Config::parse(const std::string& text, const std::string& name, std::span<const std::string> overrides) {
    auto root = parse_config_tree(text, name);
    apply_overrides(*root, overrides);
    return {std::make_shared<Document>(Document{name, {}, false}), root, ""};
}

const std::string& Config::file() const { return document_->name; }
void Config::set_particle_diameter(double diameter) { document_->particle_diameter = diameter; }
void Config::set_plain_is_si(bool plain_is_si) { document_->plain_is_si = plain_is_si; }
std::string Config::resolved() const { return to_yaml(*node_); }

std::string Config::join(std::string_view key) const {
    if (path_.empty() || key.empty()) return path_ + std::string(key);
    return fmt::format("{}.{}", path_, key);
}

void Config::fail_at(const ConfigNode& node, std::string_view key, const std::string& problem) const {
    if (!node.option.empty()) throw InputError(fmt::format("{}: {}", node.option, problem));
    const std::string full = join(key).empty() ? "" : join(key) + ": ";
    if (!node.override_text.empty()) throw InputError(fmt::format("--set {}: {}{}", node.override_text, full, problem));
    if (document_->name.empty()) throw InputError(full + problem);  // nothing was written that has a line
    throw InputError(fmt::format("{}:{}: {}{}", document_->name, node.line, full, problem));
}

void Config::fail(std::string_view key, const std::string& problem_and_advice) const {
    const auto node = key.empty() ? nullptr : node_->find(key);
    fail_at(node ? *node : *node_, key, problem_and_advice);
}

bool Config::has(std::string_view key) const {
    node_->asked.emplace(key);
    return node_->find(key) != nullptr;
}

std::vector<std::string> Config::keys() const {
    std::vector<std::string> names;
    for (const auto& [name, value] : node_->entries) names.push_back(name);
    return names;
}

ConfigNode::Pointer Config::take(std::string_view key, std::string_view wanted) const {
    node_->asked.emplace(key);
    if (auto found = node_->find(key)) {
        node_->used.emplace(key);
        return found;
    }
    std::string advice = fmt::format("the key is missing; give {} here", wanted);
    const std::string similar = closest_unknown(*node_, key);
    if (!similar.empty()) {
        advice += fmt::format(" (line {} has \"{}\": is it meant?)", node_->find(similar)->line, similar);
    }
    fail_at(*node_, key, advice);
}

const ConfigNode& Config::take_scalar(std::string_view key, std::string_view wanted) const {
    const auto node = take(key, wanted);
    if (node->kind == Kind::null) fail_at(*node, key, fmt::format("the key has no value; give {}", wanted));
    if (node->kind != Kind::scalar) {
        fail_at(*node, key,
                fmt::format("this is a {}; give {}", node->kind == Kind::list ? "list" : "mapping", wanted));
    }
    return *node;
}

bool Config::absent(std::string_view key, const std::string& default_text) const {
    if (has(key)) return false;
    auto& defaults = node_->defaults;
    const auto same = [&](const auto& entry) { return entry.first == key; };
    if (!default_text.empty() && std::none_of(defaults.begin(), defaults.end(), same))
        defaults.emplace_back(key, default_text);
    return true;
}

bool Config::is_word(std::string_view key, std::string_view word) const {
    if (!has(key)) return false;
    const ConfigNode& node = *node_->find(key);
    return node.kind == Kind::scalar && node.text == word;
}

void Config::settle(std::string_view key, const std::string& text) const {
    auto chosen = std::make_shared<ConfigNode>();
    chosen->kind = Kind::scalar;
    chosen->text = text;
    chosen->line = node_->line;
    const auto place = std::ranges::find(node_->entries, key, &std::pair<std::string, ConfigNode::Pointer>::first);
    if (place == node_->entries.end()) {
        node_->entries.emplace_back(key, std::move(chosen));
    } else {
        place->second = std::move(chosen);
    }
}

void Config::set_option(std::string_view key, const std::string& option) const {
    const auto node = node_->find(key);
    if (!node) return;
    node->option = option;
    for (const auto& item : node->items) item->option = option;
}

Config Config::section(std::string_view key) const {
    const auto node = take(key, "a group of keys");
    if (node->kind == Kind::null) node->kind = Kind::mapping;
    if (node->kind != Kind::mapping)
        fail_at(*node, key, "this is not a group of keys; write \"key: value\" lines below it");
    return {document_, node, join(key)};
}

Config Config::section_or_empty(std::string_view key) const {
    if (!has(key)) {
        auto empty = std::make_shared<ConfigNode>();
        empty->kind = Kind::mapping;
        empty->line = node_->line;
        node_->entries.emplace_back(key, empty);
    }
    return section(key);
}

std::vector<Config> Config::list(std::string_view key) const {
    const auto node = take(key, "a list");
    if (node->kind != Kind::list)
        fail_at(*node, key, "this is not a list; write items that start with \"- \" below it");
    std::vector<Config> sections;
    for (std::size_t i = 0; i < node->items.size(); ++i) {
        ConfigNode& item = *node->items[i];
        const std::string place = fmt::format("{}.{}", key, i);
        if (item.kind == Kind::scalar) {
            auto nothing = std::make_shared<ConfigNode>();
            nothing->line = item.line;
            item.entries.emplace_back(item.text, nothing);
            item.kind = Kind::mapping;
        }
        if (item.kind != Kind::mapping) fail_at(item, place, "this item has no keys; write \"- key: value\"");
        sections.push_back({document_, node->items[i], join(place)});
    }
    return sections;
}

double Config::value(std::string_view key, const ConfigNode& node, Dimension dimension, Range range,
                     bool infinite) const {
    if (infinite) {
        const auto number = parse_number(node.text.starts_with('.') ? node.text.substr(1) : node.text);
        if (number && std::isinf(*number)) return *number;
        if (node.text == "-.inf") return -std::numeric_limits<double>::infinity();
    }
    double result = 0;
    try {
        result = parse_quantity(node.text, dimension, document_->particle_diameter, document_->plain_is_si);
    } catch (const UnitError& error) {
        fail_at(node, key, error.what());
    }
    if (!range.contains(result)) {
        fail_at(node, key, fmt::format("{} is out of range; it must be {}", node.text, describe(range, dimension)));
    }
    return result;
}

double Config::quantity(std::string_view key, Dimension dimension, Range range) const {
    return value(key, take_scalar(key, wanted_quantity(dimension)), dimension, range, false);
}

double Config::quantity_or(std::string_view key, Dimension dimension, double fallback, Range range) const {
    const std::string text = std::isfinite(fallback) ? quantity_text(fallback, dimension) : "";
    return absent(key, text) ? fallback : quantity(key, dimension, range);
}

double Config::number(std::string_view key, Range range) const { return quantity(key, Dimension::none, range); }

double Config::number_or(std::string_view key, double fallback, Range range) const {
    return quantity_or(key, Dimension::none, fallback, range);
}

std::int64_t Config::integer(std::string_view key, Range range) const {
    const ConfigNode& node = take_scalar(key, "a whole number");
    const auto result = parse_integer(node.text);
    if (!result)
        fail_at(node, key, fmt::format("\"{}\" is not a whole number; write digits only, as in 2000", node.text));
    if (!range.contains(static_cast<double>(*result))) {
        fail_at(node, key, fmt::format("{} is out of range; it must be {}", *result, describe(range, Dimension::none)));
    }
    return *result;
}

std::int64_t Config::integer_or(std::string_view key, std::int64_t fallback, Range range) const {
    return absent(key, std::to_string(fallback)) ? fallback : integer(key, range);
}

bool Config::boolean(std::string_view key) const {
    const ConfigNode& node = take_scalar(key, "true or false");
    if (node.text != "true" && node.text != "false") {
        fail_at(node, key, fmt::format("\"{}\" is not true or false; write one of these", node.text));
    }
    return node.text == "true";
}

bool Config::boolean_or(std::string_view key, bool fallback) const {
    return absent(key, fallback ? "true" : "false") ? fallback : boolean(key);
}

std::string Config::text(std::string_view key) const { return take_scalar(key, "a text").text; }

std::string Config::text_or(std::string_view key, const std::string& fallback) const {
    return absent(key, fallback) ? fallback : text(key);
}

std::string Config::choice(std::string_view key, std::span<const std::string_view> allowed) const {
    const ConfigNode& node = take_scalar(key, fmt::format("one of {}", list_text(allowed)));
    if (std::find(allowed.begin(), allowed.end(), node.text) == allowed.end()) {
        fail_at(node, key, fmt::format("\"{}\" is not known; use one of {}", node.text, list_text(allowed)));
    }
    return node.text;
}

std::string Config::choice_or(std::string_view key, std::span<const std::string_view> allowed,
                              std::string_view fallback) const {
    return absent(key, std::string(fallback)) ? std::string(fallback) : choice(key, allowed);
}

}  // namespace recoat
