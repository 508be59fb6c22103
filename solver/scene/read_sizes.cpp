#include "solver/scene/read_sizes.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace recoat {
namespace {

constexpr std::array<std::string_view, 3> distributions = {"normal", "log_normal", "table"};
constexpr std::array<std::string_view, 2> weightings = {"number", "mass"};

constexpr double least_share = 1e-3;  ///< that the bounds must leave of a distribution

struct Bounds {
    double smallest, largest;
};

Bounds read_bounds(const Config& sizes) {
    const Bounds bounds{sizes.quantity("smallest", Dimension::length, Range::positive()),
                        sizes.quantity("largest", Dimension::length, Range::positive())};
    if (bounds.smallest >= bounds.largest)
        sizes.fail("largest", "the largest diameter does not exceed the smallest; give a larger one");
    return bounds;
}

/// Refuses bounds that cut nearly everything away; `low` and `high` are theirs in standard deviations.
void require_share(const Config& sizes, double low, double high) {
    const double share = 0.5 * (std::erfc(-high / std::sqrt(2.0)) - std::erfc(-low / std::sqrt(2.0)));
    if (share < least_share)
        sizes.fail("smallest",
                   "less than a thousandth of the distribution lies between smallest and largest; move them");
}

SizeDistribution read_normal(const Config& sizes, Weighting weighting) {
    const double mean = sizes.quantity("mean", Dimension::length, Range::positive());
    const double deviation = sizes.quantity("standard_deviation", Dimension::length, Range::positive());
    const Bounds bounds = read_bounds(sizes);
    require_share(sizes, (bounds.smallest - mean) / deviation, (bounds.largest - mean) / deviation);
    return SizeDistribution::normal(mean, deviation, bounds.smallest, bounds.largest, weighting);
}

SizeDistribution read_log_normal(const Config& sizes, Weighting weighting) {
    const double median = sizes.quantity("median", Dimension::length, Range::positive());
    const double deviation = sizes.number("geometric_deviation", {.lower = 1, .upper = 10, .lower_open = true});
    const Bounds bounds = read_bounds(sizes);
    const double width = std::log(deviation);
    require_share(sizes, std::log(bounds.smallest / median) / width, std::log(bounds.largest / median) / width);
    return SizeDistribution::log_normal(median, deviation, bounds.smallest, bounds.largest, weighting);
}

SizeDistribution read_table(const Config& sizes, Weighting weighting) {
    const std::vector<double> diameters = sizes.quantities("diameters", Dimension::length, 0, Range::positive());
    const std::vector<double> shares = sizes.quantities("cumulative", Dimension::none, 0, {.lower = 0, .upper = 1});
    if (diameters.size() < 2 || diameters.size() != shares.size())
        sizes.fail("cumulative", "there must be two diameters or more, and as many shares finer than them");
    if (!std::ranges::is_sorted(diameters, std::less_equal<>()))
        sizes.fail("diameters", "the diameters do not rise; sort them, each once");
    if (!std::ranges::is_sorted(shares) || shares.front() != 0 || shares.back() != 1)
        sizes.fail("cumulative", "the shares finer than the diameters must rise from 0 to 1");
    return SizeDistribution::table(diameters, shares, weighting);
}

}  // namespace

SizeDistribution read_sizes(const Config& sizes) {
    const std::string kind = sizes.choice("distribution", distributions);
    const Weighting weighting =
        sizes.choice_or("weighting", weightings, "number") == "mass" ? Weighting::mass : Weighting::number;
    if (kind == "normal") return read_normal(sizes, weighting);
    if (kind == "log_normal") return read_log_normal(sizes, weighting);
    return read_table(sizes, weighting);
}

}  // namespace recoat
