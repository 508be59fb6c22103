#pragma once

#include <array>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "common/config.hpp"

namespace recoat {

/// One value of an option and what it means.
struct OptionValue {
    std::string_view name, meaning;
};

/// A freedom that the published model leaves, as a named option of the scene. The first value is the default; values
/// stand in the order of their enumeration.
struct ModelOption {
    std::string_view section, key, question;
    std::span<const OptionValue> values;

    [[nodiscard]] std::vector<std::string_view> names() const;
    /// Index of the value chosen in `section_config`.
    [[nodiscard]] std::size_t read(const Config& section_config) const;
};

/// All options, in the order of documentation.
std::span<const ModelOption> model_options();

/// The option of that section and key; a missing one is a bug.
const ModelOption& model_option(std::string_view section, std::string_view key);

}  // namespace recoat
