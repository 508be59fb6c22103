#pragma once

#include <optional>
#include <vector>

#include "analyzer/fields/layer.hpp"

namespace recoat {

/// A sphere whose lowest point is nearer to the base than this touches it [d_p].
inline constexpr double touching_gap = 0.005;

/// Heights of the centres of the region's particles [d_p]; shares of these particles.
struct VerticalMetrics {
    /// What only a region with particles has.
    struct Summary {
        double mean = 0, max = 0;
        double fraction_above_1dp = 0;      ///< z > 1 d_p
        double fraction_touching_base = 0;  ///< z - r < 0.005 d_p
    };
    std::vector<double> bin_centres;  ///< multiples of the bin width, from 0 to the highest centre
    std::vector<double> fraction;     ///< a centre below the first bin counts in it
    std::optional<Summary> summary;
};

[[nodiscard]] VerticalMetrics vertical_metrics(const Layer& layer, double bin, double tolerance);

}  // namespace recoat
