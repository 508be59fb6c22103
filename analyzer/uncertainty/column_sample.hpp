#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "analyzer/uncertainty/block_bootstrap.hpp"

namespace recoat {

/// Amounts of several groups in every column of a layer.
class ColumnTable {
public:
    ColumnTable(int columns, std::size_t groups) : groups_(groups), amounts_(columns * groups, 0) {}

    void add(std::size_t column, std::size_t group, double amount = 1) { amounts_[column * groups_ + group] += amount; }
    /// Amount of every group in a resample.
    [[nodiscard]] std::vector<double> sums(std::span<const std::uint32_t> weights) const;

private:
    std::size_t groups_;
    std::vector<double> amounts_;  ///< index [column][group]
};

/// Values of which each belongs to a column, prepared for order statistics of many resamples.
class ColumnSample {
public:
    struct Item {
        double value;
        std::uint32_t column;
    };

    ColumnSample(std::vector<Item> items, int columns);

    [[nodiscard]] double count(std::span<const std::uint32_t> weights) const;
    /// Mean of a resample; NaN where it has no values.
    [[nodiscard]] double mean(std::span<const std::uint32_t> weights) const;
    /// Quantiles of type 7 of a resample, one for each share; NaN where it has no values. Linear in the values.
    [[nodiscard]] std::vector<double> quantiles(std::span<const std::uint32_t> weights,
                                                std::span<const double> shares) const;
    /// Mean distance of the values of a resample from their mean; NaN where it has no values.
    [[nodiscard]] double mean_deviation(std::span<const std::uint32_t> weights) const;

private:
    std::vector<double> values_;  ///< ascending
    std::vector<std::uint32_t> column_;
    ColumnTable totals_;  ///< number and sum of the values
};

}  // namespace recoat
