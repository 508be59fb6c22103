#pragma once

#include <vector>

#include "analyzer/fields/top_view.hpp"

namespace recoat {

/// When a circle meets a larger one: its centre is nearer to the centre of the other than `factor` times the radius of
/// the other, or the two overlap.
struct CircleRule {
    double factor = 1;
    bool overlap = false;

    /// Circles meet when their centres are nearer than this.
    [[nodiscard]] double distance(const Circle& larger, const Circle& smaller) const {
        return overlap ? larger.radius + smaller.radius : factor * larger.radius;
    }
};

/// From the first to the last, each circle that meets none of those selected before; distances are those of the nearest
/// images; y is in [0, period). `circles` are in the order of comes_first: from large to small.
[[nodiscard]] std::vector<Circle> greedy_circles(const std::vector<Circle>& circles, double period, CircleRule rule);

}  // namespace recoat
