#pragma once

#include "analyzer/analysis.hpp"
#include "analyzer/output/described_group.hpp"

namespace recoat {

/// Writes the size distribution of pores into a group.
void write_pore_sizes(const DescribedGroup& group, const PoreSizes& sizes);

/// Writes how a pixel form of pores differs from the exact one into a group.
void write_pore_errors(const DescribedGroup& group, const PoreErrors& errors);

/// Writes the density pores of one connectivity into a group: their size distribution and a table with one row each.
void write_density_pores(const DescribedGroup& group, const DensityPoreMetrics& metrics, const AnalysisConfig& config);

/// Writes the chamber pores of every rule, a group each: the size distribution and a table of the circles.
void write_chamber_pores(const DescribedGroup& group, const ChamberPoreMetrics& metrics, const AnalysisConfig& config);

}  // namespace recoat
