#include <numeric>
#include <random>

#include <gtest/gtest.h>

#include "solver/execution/cuda.cuh"
#include "solver/execution/openmp.hpp"

// Compiled with the host as the device (tests/support/device_on_host): the device's lists are those of the host.

namespace recoat {
namespace {

class CudaSpace : public ::testing::Test {
protected:
    template <class T>
    DeviceArray<T> on_device(const std::vector<T>& values) {
        DeviceArray<T> array;
        space_.copy(values, array);
        return array;
    }
    template <class T>
    std::vector<T> on_host(const DeviceArray<T>& array) {
        std::vector<T> values;
        space_.copy(array, values);
        return values;
    }

    Cuda space_{Resources{Backend::cuda, 1, 0}};
};

TEST_F(CudaSpace, ScanIsTheSumOfThoseBefore) {
    DeviceArray<std::int32_t> counts = on_device(std::vector<std::int32_t>{3, 0, 4, 1, 0});
    space_.exclusive_scan(counts);
    EXPECT_EQ(on_host(counts), (std::vector<std::int32_t>{0, 3, 3, 7, 8}));
    EXPECT_EQ(space_.picked(counts, 1, 2, 2), (std::vector<std::int32_t>{3, 7}));
    EXPECT_EQ(space_.picked(counts, 4, 0, 2), (std::vector<std::int32_t>{8, 8}));
}

TEST_F(CudaSpace, SortsLikeTheHost) {
    std::vector<std::uint64_t> keys(5000);
    std::iota(keys.begin(), keys.end(), std::uint64_t{1} << 40);
    std::shuffle(keys.begin(), keys.end(), std::mt19937_64(1));
    DeviceArray<std::int32_t> order;
    space_.sorted_order(on_device(keys), std::uint64_t{1} << 41, order);
    std::vector<std::int32_t> expected;
    OpenMP::sorted_order(keys, std::uint64_t{1} << 41, expected);
    EXPECT_EQ(on_host(order), expected);
}

TEST_F(CudaSpace, GroupsLikeTheHost) {
    std::mt19937_64 random(2);
    std::vector<std::int32_t> bucket(3000);
    for (std::int32_t& b : bucket) b = static_cast<std::int32_t>(random() % 301);
    DeviceArray<std::int32_t> begin, entries, buckets = on_device(bucket);
    space_.group(
        bucket.size(), 300, [b = buckets.data()](std::size_t e) { return b[e]; }, begin, entries);
    std::vector<std::int32_t> expected_begin, expected;
    OpenMP::group(
        bucket.size(), 300, [&](std::size_t e) { return bucket[e]; }, expected_begin, expected);
    EXPECT_EQ(on_host(begin), expected_begin);
    std::vector<std::int32_t> grouped = on_host(entries);
    grouped.resize(expected.size());  // what is left out comes last
    EXPECT_EQ(grouped, expected);
}

TEST_F(CudaSpace, CopiesAndFills) {
    DeviceArray<double> one = on_device(std::vector<double>{1, 2, 3}), other;
    space_.copy(one, other);
    space_.fill(one, 2, 7.0);
    space_.for_each(3, [to = other.data()](std::size_t k) { to[k] *= 10; });
    EXPECT_EQ(on_host(one), (std::vector<double>{7, 7}));
    EXPECT_EQ(on_host(other), (std::vector<double>{10, 20, 30}));
}

}  // namespace
}  // namespace recoat
