#pragma once

#include <functional>
#include <string>
#include <vector>

#include "analyzer/analysis.hpp"
#include "analyzer/uncertainty/block_bootstrap.hpp"

namespace recoat {

/// A number, or a list of numbers, of the report.
struct Quantity {
    std::string group;  ///< where it stands in the report, e.g. "density_pores/8"
    std::string name;
    std::string unit;
    bool is_list = false;
    /// Of a list: what its numbers belong to (coordination number, edge of a bin, ...).
    std::vector<double> items = {};
    bool has_interval = true;  ///< false: resamples would be copies of each other

    [[nodiscard]] std::size_t size() const { return is_list ? items.size() : 1; }
};

/// Computes some quantities for a resample of the columns of a layer.
struct Estimator {
    std::vector<Quantity> quantities;
    /// Adds the numbers of all quantities, in order; NaN where one is undefined.
    std::function<void(const ColumnWeights& weights, std::vector<double>& numbers)> evaluate;
};

/// Columns of a layer: the cells of the grid along x. A node, a particle, a circle or the middle of a pore belongs to
/// the column it lies in.
[[nodiscard]] std::size_t column_of(double x, const Grid& grid, double tolerance);

/// Of the maps of packing density and height, and of the powder per area.
[[nodiscard]] std::vector<Estimator> surface_estimators(const Analysis& analysis, const AnalysisConfig& config);
/// Of what particles are counted for: coordination number, clusters, height of the centres.
[[nodiscard]] std::vector<Estimator> particle_estimators(const Analysis& analysis, const AnalysisConfig& config);
/// Of density pores and chamber pores.
[[nodiscard]] std::vector<Estimator> pore_estimators(const Analysis& analysis, const AnalysisConfig& config);

}  // namespace recoat
