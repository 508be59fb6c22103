#pragma once

#include <filesystem>

#include "analyzer/analysis.hpp"

namespace recoat {

/// Writes chamber pores as discs at the base, regular polygons of 64 corners on the circle, with the cell array
/// Diameter [m]. A disc over the periodic boundary stays in one piece.
void write_chambers_vtp(const std::filesystem::path& place, const ChamberPores& pores, const AnalysisConfig& config);

/// Writes density pores as the squares of their cells at the base, each pore in one piece, with the cell arrays Pore
/// (from 1 in the order of the report), Cells, Diameter [m], Angle [deg, NaN: none], Elongation (NaN: none), Percolates
/// and PackingDensity.
void write_density_pores_vtp(const std::filesystem::path& place, const Analysis& analysis, const AnalysisConfig& config,
                             const DensityPoreMetrics& metrics);

}  // namespace recoat
