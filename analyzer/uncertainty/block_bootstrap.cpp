#include "analyzer/uncertainty/block_bootstrap.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "analyzer/metrics/box_stats.hpp"

namespace recoat {
namespace {

/// Output number `index` of SplitMix64, from 0.
std::uint64_t split_mix(std::uint64_t seed, std::uint64_t index) {
    std::uint64_t z = seed + (index + 1) * 0x9E3779B97F4A7C15U;
    z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9U;
    z = (z ^ (z >> 27)) * 0x94D049BB133111EBU;
    return z ^ (z >> 31);
}

}  // namespace

ColumnWeights BlockBootstrap::weights(std::size_t resample) const {
    ColumnWeights result(columns, 0);
    const int blocks = (columns + block - 1) / block;
    int missing = columns;
    for (int k = 0; k < blocks; ++k) {
        const std::uint64_t random = split_mix(seed, resample * blocks + k) >> 32;
        int column = static_cast<int>((random * static_cast<std::uint64_t>(columns)) >> 32);
        for (int taken = std::min(block, missing); taken > 0; --taken, --missing) {
            ++result[column];
            if (++column == columns) column = 0;
        }
    }
    return result;
}

Interval interval_of(std::span<const double> resampled) {
    std::vector<double> values;
    std::ranges::copy_if(resampled, std::back_inserter(values), [](double value) { return std::isfinite(value); });
    if (values.size() < 2) {
        constexpr double undefined = std::numeric_limits<double>::quiet_NaN();
        return {undefined, undefined, undefined};
    }
    std::ranges::sort(values);
    // Resamples that are equal but for the order of a sum have no scatter.
    constexpr double round_off = 1e-12;
    if (values.back() - values.front() <= round_off * std::max(std::abs(values.front()), std::abs(values.back())))
        return {values.front(), values.back(), 0};
    const double centre = mean(values);
    double squares = 0;
    for (const double value : values) squares += (value - centre) * (value - centre);
    constexpr double tail = 0.025;
    return {.lower = quantile(values, tail),
            .upper = quantile(values, 1 - tail),
            .standard_error = std::sqrt(squares / static_cast<double>(values.size() - 1))};
}

}  // namespace recoat
