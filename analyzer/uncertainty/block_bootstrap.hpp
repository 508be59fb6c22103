#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace recoat {

/// How often each column of a layer is in one resample.
using ColumnWeights = std::vector<std::uint32_t>;

/// The circular block bootstrap along x: a resample is made of blocks of neighbouring columns, drawn with replacement
/// and wrapped round the end, as many columns as the layer has.
///
/// Block k of resample b starts at column (h columns) / 2^32, h the upper half of the output number
/// b x (blocks of a resample) + k of SplitMix64 with the given seed: every resample stands for itself, whatever thread
/// makes it.
struct BlockBootstrap {
    int columns = 0;
    int block = 1;  ///< columns of a block; at least 1
    std::size_t resamples = 0;
    std::uint64_t seed = 1;

    [[nodiscard]] ColumnWeights weights(std::size_t resample) const;
};

/// What resamples say about a statistic.
struct Interval {
    double lower = 0, upper = 0;  ///< central 95 %: quantiles of type 7 at 0.025 and 0.975
    double standard_error = 0;    ///< standard deviation of the resamples
};
inline constexpr double interval_level = 0.95;

/// Resamples that are not a number count for nothing; all results are NaN where fewer than two are left.
[[nodiscard]] Interval interval_of(std::span<const double> resampled);

}  // namespace recoat
