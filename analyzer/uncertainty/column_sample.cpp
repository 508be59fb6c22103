#include "analyzer/uncertainty/column_sample.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace recoat {
namespace {

constexpr double undefined = std::numeric_limits<double>::quiet_NaN();

}  // namespace

std::vector<double> ColumnTable::sums(std::span<const std::uint32_t> weights) const {
    std::vector<double> result(groups_, 0);
    for (std::size_t column = 0; column < weights.size(); ++column) {
        if (weights[column] == 0) continue;
        const double weight = weights[column];
        for (std::size_t group = 0; group < groups_; ++group)
            result[group] += weight * amounts_[column * groups_ + group];
    }
    return result;
}

ColumnSample::ColumnSample(std::vector<Item> items, int columns) : totals_(columns, 2) {
    std::ranges::stable_sort(items, {}, &Item::value);
    for (const auto& [value, column] : items) {
        values_.push_back(value);
        column_.push_back(column);
        totals_.add(column, 0);
        totals_.add(column, 1, value);
    }
}

double ColumnSample::count(std::span<const std::uint32_t> weights) const { return totals_.sums(weights)[0]; }

double ColumnSample::mean(std::span<const std::uint32_t> weights) const {
    const std::vector<double> totals = totals_.sums(weights);
    return totals[0] > 0 ? totals[1] / totals[0] : undefined;
}

std::vector<double> ColumnSample::quantiles(std::span<const std::uint32_t> weights,
                                            std::span<const double> shares) const {
    // Number of values of the resample up to each of ours, itself included.
    std::vector<std::uint32_t> up_to(values_.size());
    std::uint32_t number = 0;
    for (std::size_t i = 0; i < values_.size(); ++i) up_to[i] = number += weights[column_[i]];
    if (number == 0) return std::vector<double>(shares.size(), undefined);
    const auto at_rank = [&](std::uint32_t rank) {
        return values_[std::ranges::upper_bound(up_to, rank) - up_to.begin()];
    };
    std::vector<double> result;
    for (const double share : shares) {
        const double place = share * (number - 1);
        const auto below = static_cast<std::uint32_t>(place);
        const std::uint32_t above = std::min(below + 1, number - 1);
        result.push_back(std::lerp(at_rank(below), at_rank(above), place - below));
    }
    return result;
}

double ColumnSample::mean_deviation(std::span<const std::uint32_t> weights) const {
    const double centre = mean(weights);
    // The values below the mean are as far from it, all together, as those above.
    double below = 0;
    for (std::size_t i = 0; i < values_.size() && values_[i] < centre; ++i) {
        below += weights[column_[i]] * (centre - values_[i]);
    }
    return std::isnan(centre) ? undefined : 2 * below / count(weights);
}

}  // namespace recoat
