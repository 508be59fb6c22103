#pragma once

#include <vector>

#include "analyzer/analysis.hpp"

namespace recoat {

/// The cells of the density pores, in the order of `metrics.pores`.
[[nodiscard]] std::vector<GridPore> pore_cells(const Analysis& analysis, const AnalysisConfig& config,
                                               const DensityPoreMetrics& metrics);

/// At every node of the map of packing density the number of its pore, from 1 in the order of `metrics.pores`; 0: none.
[[nodiscard]] Map pore_numbers(const Analysis& analysis, const AnalysisConfig& config,
                               const DensityPoreMetrics& metrics);

}  // namespace recoat
