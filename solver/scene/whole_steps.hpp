#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace recoat {

/// Steps beyond which no stage and no interval goes: thirty years at a million steps per second, and still exact as a
/// double.
inline constexpr double most_steps = 1e15;

/// Number of steps nearest to `duration` [s], at most `most_steps`.
inline std::int64_t whole_steps(double duration, double time_step) {
    return std::llround(std::min(duration / time_step, most_steps));
}

}  // namespace recoat
