#pragma once

#include <filesystem>

#include "analyzer/analysis.hpp"

namespace recoat {

/// Writes the maps as cells of an image at the base, lengths in metres: PackingDensity, PackingDensityCentre, Height
/// [m], DensityPore4, DensityPore8 (number of the pore from 1, 0: none); NaN, or 0 for pores, where outer nodes were
/// dropped.
void write_maps_vti(const std::filesystem::path& place, const Analysis& analysis, const AnalysisConfig& config);

}  // namespace recoat
