#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include <omp.h>

namespace recoat {

/// Runs loops on the host's threads. The same bits come out for any number of threads, because a thread takes whole
/// blocks, block limits do not depend on the threads, and every block runs through the same vector loop.
class OpenMP {
public:
    explicit OpenMP(int threads) : threads_(std::max(1, threads)) {}

    [[nodiscard]] int threads() const { return threads_; }

    /// f(k) for 0 <= k < n; iterations are independent.
    template <class Function>
    void for_each(std::size_t n, const Function& f) const {
        over_blocks(n, [&](std::size_t, std::size_t begin, std::size_t end) {
            for (std::size_t k = begin; k < end; ++k) f(k);
        });
    }

    /// As for_each, vectorised; returns the largest f(k), or 0.
    template <class Function>
    double for_each_max(std::size_t n, const Function& f) {
        peaks_.assign(blocks(n), 0.0);
        over_blocks(n,
                    [&](std::size_t b, std::size_t begin, std::size_t end) { peaks_[b] = vector_max(f, begin, end); });
        return peaks_.empty() ? 0.0 : *std::max_element(peaks_.begin(), peaks_.end());
    }

    /// As for_each_max without vectorisation, for bodies with inner loops.
    template <class Function>
    double for_each_max_scalar(std::size_t n, const Function& f) {
        peaks_.assign(blocks(n), 0.0);
        over_blocks(n, [&](std::size_t b, std::size_t begin, std::size_t end) {
            double peak = 0;
            for (std::size_t k = begin; k < end; ++k) peak = std::max(peak, f(k));
            peaks_[b] = peak;
        });
        return peaks_.empty() ? 0.0 : *std::max_element(peaks_.begin(), peaks_.end());
    }

private:
    static constexpr std::size_t block_size = 512;
    static constexpr std::size_t least_blocks = 6;  ///< fewer are done before a second thread has woken up

    /// The vector loop, in a function of its own and on a copy of `f`: then the compiler knows that nothing else writes
    /// to its numbers.
    template <class Function>
    __attribute__((noinline)) static double vector_max(const Function& f, std::size_t begin, std::size_t end) {
        const Function local = f;
        double peak = 0;
#pragma omp simd reduction(max : peak)
        for (std::size_t k = begin; k < end; ++k) {
            const double value = local(k);
            peak = value > peak ? value : peak;
        }
        return peak;
    }

    static std::size_t blocks(std::size_t n) { return (n + block_size - 1) / block_size; }

    template <class Body>
    void over_blocks(std::size_t n, const Body& body) const {
        const std::size_t count = blocks(n);
        if (threads_ == 1 || count < least_blocks) {
            for (std::size_t b = 0; b < count; ++b) body(b, b * block_size, std::min(n, (b + 1) * block_size));
            return;
        }
#pragma omp parallel for schedule(static) num_threads(threads_)
        for (std::size_t b = 0; b < count; ++b) body(b, b * block_size, std::min(n, (b + 1) * block_size));
    }

    int threads_;
    std::vector<double> peaks_;
};

}  // namespace recoat
