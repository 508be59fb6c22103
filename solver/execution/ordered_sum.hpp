#pragma once

#include <cstddef>

#include "common/host_device.hpp"

namespace recoat {

/// The order in which every sum over many terms is taken, on the host as on a device: blocks of 1024 terms, each as 32
/// lanes of 32 terms a stride of 32 apart, the lanes then halved together; block sums are summed in the same way.
struct OrderedSum {
    static constexpr std::size_t lanes = 32, terms = 32, block = lanes * terms;

    static constexpr std::size_t blocks(std::size_t n) { return (n + block - 1) / block; }

    /// Sum of one lane of block `b`.
    template <class Function>
    RECOAT_HD static double lane(const Function& f, std::size_t b, std::size_t lane, std::size_t n) {
        double sum = 0;
        for (std::size_t m = 0; m < terms; ++m) {
            const std::size_t k = b * block + m * lanes + lane;
            if (k < n) sum += f(k);
        }
        return sum;
    }

    /// Sum of block `b`, by one thread.
    template <class Function>
    static double of_block(const Function& f, std::size_t b, std::size_t n) {
        double sum[lanes];
        for (std::size_t l = 0; l < lanes; ++l) sum[l] = lane(f, b, l, n);
        for (std::size_t half = lanes / 2; half > 0; half /= 2)
            for (std::size_t l = 0; l < half; ++l) sum[l] += sum[l + half];
        return sum[0];
    }
};

}  // namespace recoat
