#include <fmt/format.h>

#include "common/config.hpp"
#include "common/number.hpp"

namespace recoat {

ConfigNode::Pointer Config::take_list(std::string_view key, std::string_view wanted, std::size_t expected_size) const {
    auto node = take(key, wanted);
    if (node->kind != ConfigNode::Kind::list) fail_at(*node, key, fmt::format("this is not a list; give {}", wanted));
    if (expected_size != 0 && node->items.size() != expected_size) {
        fail_at(*node, key, fmt::format("the list has {} values; give {}", node->items.size(), wanted));
    }
    for (const auto& item : node->items) {
        if (item->kind != ConfigNode::Kind::scalar)
            fail_at(*item, key, fmt::format("an item is no plain value; give {}", wanted));
    }
    return node;
}

std::vector<double> Config::quantities(std::string_view key, Dimension dimension, std::size_t expected_size,
                                       Range range) const {
    const std::string count = expected_size == 0 ? "" : fmt::format("{} values, each ", expected_size);
    const auto node = take_list(key, fmt::format("a list of {}{}", count, dimension_name(dimension)), expected_size);
    std::vector<double> values;
    for (const auto& item : node->items) values.push_back(value(key, *item, dimension, range, false));
    return values;
}

Vec3 Config::vector(std::string_view key, Dimension dimension, bool infinite) const {
    const auto node = take_list(key, fmt::format("three components [x, y, z], each {}", dimension_name(dimension)), 3);
    const auto component = [&](std::size_t i) { return value(key, *node->items[i], dimension, {}, infinite); };
    return {component(0), component(1), component(2)};
}

Vec3 Config::vector_or(std::string_view key, Dimension dimension, Vec3 fallback, bool infinite) const {
    if (!has(key)) {
        add_default_list(key, dimension, fallback);
        return fallback;
    }
    return vector(key, dimension, infinite);
}

void Config::add_default_list(std::string_view key, Dimension dimension, Vec3 value) const {
    auto list = std::make_shared<ConfigNode>();
    list->kind = ConfigNode::Kind::list;
    list->line = node_->line;
    for (const double component : {value.x, value.y, value.z}) {
        auto item = std::make_shared<ConfigNode>();
        item->kind = ConfigNode::Kind::scalar;
        item->text = std::string(trimmed(fmt::format("{} {}", shortest(component), si_unit(dimension))));
        list->items.push_back(item);
    }
    node_->entries.emplace_back(key, list);
    node_->used.emplace(key);
}

std::vector<std::string> Config::texts(std::string_view key) const {
    std::vector<std::string> words;
    const ConfigNode::Pointer list = take_list(key, "a list of words", 0);
    for (const auto& item : list->items) words.push_back(item->text);
    return words;
}

}  // namespace recoat
