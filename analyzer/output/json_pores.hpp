#pragma once

#include <nlohmann/json.hpp>

#include "analyzer/analysis.hpp"

namespace recoat {

/// Size distribution of pores.
[[nodiscard]] nlohmann::ordered_json json_pore_sizes(const PoreSizes& sizes);

/// Density pores: one object for each connectivity, "4" and "8".
[[nodiscard]] nlohmann::ordered_json json_density_pores(const std::vector<DensityPoreMetrics>& metrics);

/// Chamber pores: one object for each rule, "L", "A", "B" and, for equal radii, "P".
[[nodiscard]] nlohmann::ordered_json json_chamber_pores(const ChamberPoreMetrics& metrics);

}  // namespace recoat
