#include <fmt/format.h>
#include <fmt/ranges.h>

#include "common/config.hpp"
#include "common/config_spelling.hpp"

namespace recoat {

void Config::refuse_unread(const std::string& key, const ConfigNode& value) const {
    if (node_->asked.contains(key)) {
        fail_at(value, key, "the key has no effect beside the others that are given; remove it");
    }
    const std::string meant = closest_known(*node_, key);
    if (!meant.empty()) fail_at(value, key, fmt::format("the key is unknown; did you mean \"{}\"?", meant));
    if (node_->asked.empty()) fail_at(value, key, "the key is unknown and nothing is expected here; remove it");
    fail_at(value, key, fmt::format("the key is unknown; remove it or use one of {}", fmt::join(node_->asked, ", ")));
}

void Config::allow_only(std::span<const std::string_view> keys) const {
    for (const std::string_view key : keys) node_->asked.emplace(key);
    for (const auto& [key, value] : node_->entries) {
        if (!node_->asked.contains(key)) refuse_unread(key, *value);
    }
}

void Config::finish() const {
    for (const auto& [key, value] : node_->entries) {
        if (!node_->used.contains(key)) refuse_unread(key, *value);
        if (value->kind == ConfigNode::Kind::mapping) Config(document_, value, join(key)).finish();
        for (std::size_t i = 0; i < value->items.size(); ++i) {
            const auto& item = value->items[i];
            if (item->kind == ConfigNode::Kind::mapping)
                Config(document_, item, fmt::format("{}.{}", join(key), i)).finish();
        }
    }
}

}  // namespace recoat
