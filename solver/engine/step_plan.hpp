#pragma once

#include <algorithm>
#include <cstdint>

#include "solver/engine/step_control.hpp"

namespace recoat {

/// Steps to start at once: up to the target, but few more than the close list is likely to last. A device that has been
/// given too many passes over the rest without doing them, one that has been given too few waits for the host.
inline std::int64_t planned_steps(const StepControl& c) {
    const std::int64_t wanted = c.target - c.step;
    if (!(c.last_travel > 0)) return wanted;
    const double left = (0.5 * c.margin - c.travelled) / c.last_travel - 2;
    const double likely = 1.05 * std::max(left, 0.0) + 2;
    return likely < static_cast<double>(wanted) ? static_cast<std::int64_t>(likely) : wanted;
}

}  // namespace recoat
