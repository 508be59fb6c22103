#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numeric>
#include <utility>
#include <vector>

#include "common/one_copy.hpp"
#include "solver/execution/ordered_sum.hpp"
#include "solver/execution/reductions.hpp"
#include "solver/execution/resources.hpp"

namespace recoat {

/// Runs loops on the host's threads. The same bits come out for any number of threads, because a thread takes whole
/// blocks, block limits do not depend on the threads, and every block runs through the same vector loop.
class OpenMP {
public:
    static constexpr bool on_host = true;
    template <class T>
    using Array = std::vector<T>;

    explicit OpenMP(int threads) : threads_(std::max(1, threads)) {}
    explicit OpenMP(const Resources& resources) : OpenMP(resources.threads) {}

    [[nodiscard]] int threads() const { return threads_; }

    template <class T>
    static void copy(const std::vector<T>& from, std::vector<T>& to) {
        to = from;
    }
    template <class T>
    static void fill(std::vector<T>& array, std::size_t n, T value) {
        array.assign(n, value);
    }

    /// f(k) for 0 <= k < n; iterations are independent.
    template <class Function>
    void for_each(std::size_t n, const Function& f) const {
        over_blocks(n, [&](std::size_t, std::size_t begin, std::size_t end) {
            for (std::size_t k = begin; k < end; ++k) f(k);
        });
    }

    /// Largest f(k), or minus infinity.
    template <class Function>
    double maximum(std::size_t n, const Function& f) {
        const double none = -std::numeric_limits<double>::infinity();
        return peak_of_blocks(n, none, [&](std::size_t begin, std::size_t end) {
            double peak = none;
            for (std::size_t k = begin; k < end; ++k) peak = std::max(peak, f(k));
            return peak;
        });
    }

    /// Sum of f(k), in the order of OrderedSum.
    template <class Function>
    double sum(std::size_t n, const Function& f) const {
        std::vector<double> sums = block_sums(n, f);
        while (sums.size() > 1) sums = block_sums(sums.size(), [&](std::size_t b) { return sums[b]; });
        return sums.empty() ? 0 : sums.front();
    }

    /// Sums and maxima, each as it would be alone.
    template <class... Reductions>
    std::array<double, sizeof...(Reductions)> reduce(const Reductions&... reductions) {
        return {value_of(reductions)...};
    }

    /// Every entry becomes the sum of those before it.
    static void exclusive_scan(std::vector<std::int32_t>& counts) {
        std::exclusive_scan(counts.begin(), counts.end(), counts.begin(), 0);
    }

    /// `count` entries of an array, `stride` apart.
    static std::vector<std::int32_t> picked(const std::vector<std::int32_t>& array, std::size_t first,
                                            std::size_t stride, std::size_t count) {
        std::vector<std::int32_t> entries;
        for (std::size_t k = 0; k < count; ++k) entries.push_back(array[first + k * stride]);
        return entries;
    }

    /// Order in which `keys` ascend; they differ and lie below `bound`.
    static void sorted_order(const std::vector<std::uint64_t>& keys, std::uint64_t /*bound*/,
                             std::vector<std::int32_t>& order) {
        std::vector<std::pair<std::uint64_t, std::int32_t>> pairs(keys.size());
        for (std::size_t i = 0; i < keys.size(); ++i) pairs[i] = {keys[i], static_cast<std::int32_t>(i)};
        std::sort(pairs.begin(), pairs.end());
        order.resize(keys.size());
        for (std::size_t i = 0; i < keys.size(); ++i) order[i] = pairs[i].second;
    }

    /// Entries 0 .. n - 1 by bucket, ascending within each; `begin` has `buckets` + 1 places. Entries whose bucket is
    /// `buckets` are left out.
    template <class Bucket>
    static void group(std::size_t n, std::size_t buckets, const Bucket& bucket, std::vector<std::int32_t>& begin,
                      std::vector<std::int32_t>& entries) {
        begin.assign(buckets + 2, 0);
        for (std::size_t e = 0; e < n; ++e) ++begin[static_cast<std::size_t>(bucket(e)) + 1];
        std::partial_sum(begin.begin(), begin.end(), begin.begin());
        begin.pop_back();
        entries.resize(static_cast<std::size_t>(begin[buckets]));
        std::vector<std::int32_t> next(begin.begin(), begin.end() - 1);
        for (std::size_t e = 0; e < n; ++e) {
            const auto b = static_cast<std::size_t>(bucket(e));
            if (b < buckets) entries[static_cast<std::size_t>(next[b]++)] = static_cast<std::int32_t>(e);
        }
    }

    /// Calls `body` up to `count` times, as long as `end` says that it goes on.
    template <class End, class Body>
    static void repeat(std::int64_t count, const End& end, const Body& body) {
        for (std::int64_t k = 0; k < count && end.running(); ++k) body();
    }

    /// Runs a guarded loop, if it is open: its peak becomes the largest value that it returns.
    template <class Loop>
    void run(const Loop& loop) {
        if (!loop.open()) return;
        loop.segments([&](const auto& pass, std::size_t count) {
            double peak = 0;
            if constexpr (Loop::vector)
                peak = peak_of_blocks(count, 0,
                                      [&](std::size_t begin, std::size_t end) { return vector_max(pass, begin, end); });
            else
                peak = std::max(0.0, maximum(count, pass));
            *loop.peak = std::max(*loop.peak, peak);
        });
    }

    /// The same, then `end`.
    template <class Loop, class End>
    void run_last(const Loop& loop, const End& end) {
        run(loop);
        end();
    }

private:
    template <class Function>
    double value_of(const SumOf<Function>& reduction) {
        return sum(reduction.n, reduction.f);
    }
    template <class Function>
    double value_of(const MaximumOf<Function>& reduction) {
        return maximum(reduction.n, reduction.f);
    }

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

    template <class Function>
    [[nodiscard]] std::vector<double> block_sums(std::size_t n, const Function& f) const {
        std::vector<double> sums(OrderedSum::blocks(n));
        for_each(sums.size(), [&](std::size_t b) { sums[b] = OrderedSum::of_block(f, b, n); });
        return sums;
    }

    static std::size_t blocks(std::size_t n) { return (n + block_size - 1) / block_size; }

    template <class Body>
    double peak_of_blocks(std::size_t n, double none, const Body& body) {
        peaks_.assign(blocks(n), none);
        over_blocks(n, [&](std::size_t b, std::size_t begin, std::size_t end) { peaks_[b] = body(begin, end); });
        return peaks_.empty() ? none : *std::max_element(peaks_.begin(), peaks_.end());
    }

    template <class Body>
    void over_blocks(std::size_t n, const Body& body) const {
        const std::size_t count = blocks(n);
        if (threads_ == 1 || count < least_blocks) {
            for (std::size_t b = 0; b < count; ++b) call_block(body, b, n);
            return;
        }
#pragma omp parallel for schedule(static) num_threads(threads_)
        for (std::size_t b = 0; b < count; ++b) call_block(body, b, n);
    }

    template <class Body>
    RECOAT_ONE_COPY static void call_block(const Body& body, std::size_t b, std::size_t n) {
        body(b, b * block_size, std::min(n, (b + 1) * block_size));
    }

    int threads_;
    std::vector<double> peaks_;
};

}  // namespace recoat
