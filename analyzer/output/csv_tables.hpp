#pragma once

#include <filesystem>

#include "analyzer/analysis.hpp"
#include "analyzer/uncertainty/uncertainty.hpp"

namespace recoat {

/// Writes the results as CSV tables into a folder: `metrics` (every number of the report by its key, with its interval
/// where it has one), `particles`, `maps` (one row per node), `density_pores_4`, `density_pores_8` and `chamber_pores`
/// (of every rule). Lengths in d_p, but x, y, z and radius of particles, nodes and pores in metres; an undefined value
/// leaves its cell empty. Throws InputError.
void write_csv_tables(const std::filesystem::path& folder, const Analysis& analysis, const AnalysisConfig& config,
                      const Uncertainty& uncertainty);

/// The rows of `metrics`: key, value, lower, upper, standard_error of every number but the lists of all pores.
struct MetricRow {
    std::string key;  ///< e.g. "height/Ra", "clusters/cn_fraction/2"
    std::string value, lower, upper, standard_error;
};
[[nodiscard]] std::vector<MetricRow> metric_rows(const Analysis& analysis, const AnalysisConfig& config,
                                                 const Uncertainty& uncertainty);

}  // namespace recoat
