#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include <gtest/gtest.h>

#include "solver/execution/cuda.cuh"
#include "solver/execution/openmp.hpp"

// Compiled with the host as the device (tests/support/device_on_host).

namespace recoat {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();
const std::size_t sizes[] = {0, 1, 31, 33, 127, 128, 1023, 1024, 1025, 5000, 1'100'000};

std::vector<double> random_numbers(std::size_t n) {
    std::mt19937_64 random(n);
    std::normal_distribution<double> normal;
    std::vector<double> values(n);
    for (double& value : values) value = normal(random) * std::exp(20 * normal(random));
    return values;
}

class CudaReductions : public ::testing::Test {
protected:
    auto entries_of(const std::vector<double>& values) {
        space_.copy(values, array_);
        return [value = array_.data()](std::size_t k) { return value[k]; };
    }

    Cuda space_{Resources{Backend::cuda, 1, 0}};
    DeviceArray<double> array_;
};

TEST_F(CudaReductions, SumsAreThoseOfTheHostToTheBit) {
    for (const std::size_t n : sizes) {
        const std::vector<double> values = random_numbers(n);
        EXPECT_EQ(space_.sum(n, entries_of(values)), OpenMP(1).sum(n, [&](std::size_t k) { return values[k]; })) << n;
    }
}

TEST_F(CudaReductions, MaximumIsTheLargestOrNone) {
    for (const std::size_t n : {0UL, 1UL, 31UL, 33UL, 127UL, 128UL, 5000UL, 140'000UL}) {
        std::vector<double> values = random_numbers(n);
        for (double& value : values) value = -std::fabs(value);
        EXPECT_EQ(space_.maximum(n, entries_of(values)), OpenMP(1).maximum(n, [&](std::size_t k) { return values[k]; }))
            << n;
    }
}

TEST_F(CudaReductions, NotANumberHidesNoLargerValue) {
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    for (std::size_t at = 0; at < 130; ++at) {
        std::vector<double> values(130, -3.0);
        values[at] = nan;
        values[(at + 17) % 130] = 5;
        EXPECT_EQ(space_.maximum(130, entries_of(values)), 5) << at;
        EXPECT_EQ(OpenMP(1).maximum(130, [&](std::size_t k) { return values[k]; }), 5) << at;
    }
    EXPECT_EQ(space_.maximum(130, entries_of(std::vector<double>(130, nan))), -infinite);
}

TEST_F(CudaReductions, ManyAtOnceAreWhatTheyAreAlone) {
    const std::vector<double> values = random_numbers(20'000);
    const auto at = entries_of(values);
    const auto square = [at](std::size_t k) { return at(k) * at(k); };
    const auto minus = [at](std::size_t k) { return -at(k); };
    const double alone[] = {space_.sum(20'000, at), space_.maximum(20'000, minus), space_.sum(0, at),
                            space_.sum(1000, square), space_.maximum(5, at)};
    const std::uint64_t launches = host_device.launches, waits = host_device.waits;
    const auto together =
        space_.reduce(SumOf{20'000, at}, MaximumOf{20'000, minus}, SumOf{0, at}, SumOf{1000, square}, MaximumOf{5, at});
    EXPECT_EQ(host_device.launches - launches, 1u);
    EXPECT_EQ(host_device.waits - waits, 1u);
    for (std::size_t k = 0; k < 5; ++k) EXPECT_EQ(together[k], alone[k]) << k;
    EXPECT_EQ(OpenMP(2).reduce(SumOf{20'000, at}, MaximumOf{5, at}), (std::array{alone[0], alone[4]}));
}

}  // namespace
}  // namespace recoat
