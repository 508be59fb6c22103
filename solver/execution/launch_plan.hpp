#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace recoat {

/// Repetitions of one captured graph of `steps` steps.
struct Launch {
    std::int64_t steps, times;

    friend bool operator==(const Launch&, const Launch&) = default;
};

/// Sizes of the graphs that are kept: few enough to be captured quickly, so spaced that any number of steps needs few
/// launches, the largest long enough that the host's part in it does not show.
inline constexpr std::array<std::int64_t, 4> graph_sizes = {256, 32, 4, 1};

/// Which graphs make `count` steps, largest first.
inline std::vector<Launch> plan_launches(std::int64_t count) {
    std::vector<Launch> plan;
    for (const std::int64_t steps : graph_sizes) {
        if (count < steps) continue;
        plan.push_back({steps, count / steps});
        count %= steps;
    }
    return plan;
}

/// Places to allocate for an array that needs `wanted`: with slack, because lists grow and shrink by a few entries
/// whenever they are made anew, and a new place in memory means new graphs.
inline std::size_t grown_capacity(std::size_t wanted) { return wanted + wanted / 8 + 64; }

/// Blocks of a kernel for `n` threads.
inline unsigned block_count(std::size_t n, unsigned block_size) {
    return static_cast<unsigned>(std::max<std::size_t>(1, (n + block_size - 1) / block_size));
}

/// Lowest bits in which numbers up to `largest` differ.
inline int significant_bits(std::uint64_t largest) {
    int bits = 1;
    while (bits < 64 && largest >> bits != 0) ++bits;
    return bits;
}

}  // namespace recoat
