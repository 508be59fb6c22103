#pragma once

#include <string>

#include <nlohmann/json.hpp>

#include "analyzer/convergence.hpp"

namespace recoat {

/// A table for the terminal: every quantity, exact and by voxels, with its errors, order and sufficient resolution.
[[nodiscard]] std::string convergence_text(const Convergence& convergence);

/// The same as one JSON object.
[[nodiscard]] nlohmann::ordered_json convergence_json(const Convergence& convergence);

}  // namespace recoat
