#pragma once

#include <nlohmann/json.hpp>

#include "analyzer/uncertainty/uncertainty.hpp"

namespace recoat {

/// How the intervals were made, and below the keys of the report `value`, `lower`, `upper`, `standard_error` of every
/// quantity: numbers, or lists with `items`; null where undefined.
[[nodiscard]] nlohmann::ordered_json json_uncertainty(const Uncertainty& uncertainty);

}  // namespace recoat
