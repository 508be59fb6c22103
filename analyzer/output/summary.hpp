#pragma once

#include <optional>
#include <string>

#include "analyzer/analysis.hpp"
#include "analyzer/uncertainty/uncertainty.hpp"

namespace recoat {

/// The main results of an analysis on one page for the terminal: where the layer lies, every main number with its
/// interval, the pores, and how far the voxel forms are from the exact ones.
[[nodiscard]] std::string text_summary(const Analysis& analysis, const AnalysisConfig& config,
                                       const std::optional<Uncertainty>& uncertainty = {});

}  // namespace recoat
