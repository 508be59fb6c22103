#pragma once

#include <string>

namespace recoat {

/// What `recoat-solve models` prints: every named option of the model, its values, their meaning and the default.
std::string models_text();

}  // namespace recoat
