#pragma once

#include <array>
#include <cstddef>
#include <vector>

namespace recoat {

/// Distribution of the diameters of pores. All 0 for no pores.
struct PoreSizes {
    static constexpr std::size_t groups = 6;  ///< [0, 1), [1, 2), ... [4, 5) and [5, infinity) d_p

    std::size_t count = 0;
    double mean = 0, median = 0, max = 0;                ///< [d_p]
    std::array<double, groups> group_number_fraction{};  ///< share of the pores per group
    std::array<double, groups> group_area_fraction{};    ///< the same weighted with the squared diameters
    std::vector<double> sorted;                          ///< all diameters, ascending [d_p]
};

/// Group of a diameter.
[[nodiscard]] std::size_t pore_size_group(double diameter, double tolerance);

/// Groups are closed below; a diameter within `tolerance` below an edge counts as on it.
[[nodiscard]] PoreSizes pore_sizes(std::vector<double> diameters, double tolerance);

}  // namespace recoat
