#pragma once

#include <optional>

#include <nlohmann/json.hpp>

#include "analyzer/analysis.hpp"
#include "analyzer/uncertainty/uncertainty.hpp"

namespace recoat {

/// Every metric, the maps and the values per particle (in the order of the file) as one JSON object. Numbers read back
/// to the same bits; null where a quantity is undefined. Lengths in d_p unless the name carries a unit.
[[nodiscard]] nlohmann::ordered_json json_report(const Analysis& analysis, const AnalysisConfig& config,
                                                 const std::optional<Uncertainty>& uncertainty = {});

/// The resolved configuration: d_p, h_b, base, x_range, y_min, y_period and density in SI units, the rest in d_p.
[[nodiscard]] nlohmann::ordered_json json_config(const AnalysisConfig& config);

}  // namespace recoat
