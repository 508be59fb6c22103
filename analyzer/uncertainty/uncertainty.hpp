#pragma once

#include <vector>

#include "analyzer/analysis.hpp"
#include "analyzer/uncertainty/block_bootstrap.hpp"
#include "analyzer/uncertainty/estimator.hpp"

namespace recoat {

/// A quantity of the report with its interval; one entry per number.
struct Estimate {
    Quantity quantity;
    std::vector<double> value;  ///< of the layer itself
    std::vector<Interval> interval;
};

/// Intervals of the statistics of one layer. They hold the scatter between places of this layer along x, not that
/// between layers.
struct Uncertainty {
    BlockBootstrap bootstrap;
    double block_length = 0;  ///< [d_p]
    std::vector<Estimate> estimates;

    /// The estimate of a quantity that is there. Throws std::out_of_range.
    [[nodiscard]] const Estimate& at(std::string_view group, std::string_view name) const;
};

/// Bootstraps every statistic of an analysis; pores are resampled as wholes, by the place of their middle. The same
/// bits with any number of threads. A block is at most a quarter of the region, so that at least four make a resample.
[[nodiscard]] Uncertainty bootstrap(const Analysis& analysis, const AnalysisConfig& config);

}  // namespace recoat
