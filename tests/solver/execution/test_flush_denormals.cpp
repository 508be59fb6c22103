#include <limits>

#include <gtest/gtest.h>

#include "solver/execution/flush_denormals.hpp"

namespace recoat {
namespace {

/// Half of a number, worked out when the program runs.
double half(double x) {
    const volatile double run_time = x;
    return 0.5 * run_time;
}

TEST(FlushDenormals, OnlyWhileItLives) {
    constexpr double smallest = std::numeric_limits<double>::min();
    EXPECT_GT(half(smallest), 0);
#if defined(__SSE2__)
    {
        const FlushDenormals flush;
        EXPECT_EQ(half(smallest), 0);
    }
#endif
    EXPECT_GT(half(smallest), 0);
}

}  // namespace
}  // namespace recoat
