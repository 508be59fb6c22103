#pragma once

#include <algorithm>
#include <numeric>
#include <vector>

#include "tests/support/device_on_host/cuda_runtime.h"

namespace cub {

/// As the library's: stable, by the bits [first_bit, end_bit) of the keys.
struct DeviceRadixSort {
    template <class Key, class Value>
    static cudaError_t SortPairs(void* scratch, std::size_t& bytes, const Key* keys, Key* sorted_keys,
                                 const Value* values, Value* sorted_values, std::size_t n, int first_bit, int end_bit,
                                 cudaStream_t stream) {
        if (scratch == nullptr) return bytes = 1, cudaSuccess;
        const int width = end_bit - first_bit;
        const Key mask = width >= static_cast<int>(8 * sizeof(Key)) ? ~Key{0} : (Key{1} << width) - 1;
        stream->add([=](Crew&) {
            std::vector<std::size_t> order(n);
            std::iota(order.begin(), order.end(), std::size_t{0});
            std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
                return (keys[a] >> first_bit & mask) < (keys[b] >> first_bit & mask);
            });
            for (std::size_t k = 0; k < n; ++k) {
                sorted_keys[k] = keys[order[k]];
                sorted_values[k] = values[order[k]];
            }
        });
        return cudaSuccess;
    }
};

}  // namespace cub
