#include "solver/cli/models.hpp"

#include <fmt/format.h>

#include "solver/scene/model_options.hpp"

namespace recoat {

std::string models_text() {
    std::string text;
    for (const ModelOption& option : model_options()) {
        text += fmt::format("{}.{}: {}\n", option.section, option.key, option.question);
        for (const OptionValue& value : option.values) {
            const bool is_default = &value == &option.values.front();
            text += fmt::format("  {:<22} {}{}\n", value.name, value.meaning, is_default ? " (default)" : "");
        }
    }
    return text;
}

}  // namespace recoat
