#pragma once

#include <algorithm>
#include <array>
#include <vector>

#include <cub/device/device_radix_sort.cuh>
#include <cub/device/device_scan.cuh>

#include "solver/execution/cuda_graphs.cuh"
#include "solver/execution/cuda_kernels.cuh"
#include "solver/execution/cuda_reductions.cuh"
#include "solver/execution/pinned_array.cuh"
#include "solver/execution/resources.hpp"

namespace recoat {

/// Runs loops on a CUDA device; offers what OpenMP does. Every space has a stream of its own, so that several share a
/// device. Sums are those of OrderedSum, so that the same bits come out in every run.
class Cuda {
public:
    static constexpr bool on_host = false;
    template <class T>
    using Array = DeviceArray<T>;

    explicit Cuda(const Resources& resources) : device_(resources.device) {
        use();
        check_cuda(cudaStreamCreateWithFlags(&stream_, cudaStreamNonBlocking), "making a stream");
        fill(ticket_, 1 + most_reductions, 0U);
    }
    Cuda(const Cuda&) = delete;
    Cuda& operator=(const Cuda&) = delete;
    ~Cuda() { cudaStreamDestroy(stream_); }

    template <class T>
    void copy(const DeviceArray<T>& from, DeviceArray<T>& to) {
        use();
        to.resize(from.size());
        move(to.data(), from.data(), from.size() * sizeof(T), cudaMemcpyDeviceToDevice);
    }
    template <class T>
    void copy(const std::vector<T>& from, DeviceArray<T>& to) {
        use();
        to.resize(from.size());
        // The driver has taken what the host handed over when the call returns: that is how pageable memory is copied.
        move(to.data(), from.data(), from.size() * sizeof(T), cudaMemcpyHostToDevice);
    }
    template <class T>
    void copy(const DeviceArray<T>& from, std::vector<T>& to) {
        use();
        to.resize(from.size());
        move(to.data(), from.data(), from.size() * sizeof(T), cudaMemcpyDeviceToHost);
        wait();
    }
    template <class T>
    void fill(DeviceArray<T>& array, std::size_t n, T value) {
        use();
        array.resize(n);
        launch(kernels::fill<T>, n, array.data(), n, value);
    }

    template <class Function>
    void for_each(std::size_t n, const Function& f) {
        use();
        launch(kernels::each<Function>, n, f, n);
    }

    /// All of them in one kernel, and one wait.
    template <class... Reductions>
    std::array<double, sizeof...(Reductions)> reduce(const Reductions&... reductions) {
        constexpr std::size_t count = sizeof...(Reductions);
        static_assert(count > 0 && count <= most_reductions);
        use();
        const std::size_t threads = std::max({kernels::useful_threads(reductions)...});
        const unsigned blocks = std::min(maximum_blocks, block_count(threads, kernels::block_size));
        partial_.resize((kernels::partial_size(reductions, blocks) + ...));
        launch_grid(kernels::reduce<Reductions...>, dim3(blocks, count),
                    reduction_parts(blocks, 0, partial_.data(), reductions...));
        wait();
        std::array<double, count> results;
        std::copy_n(results_.data(), count, results.begin());
        return results;
    }

    template <class Function>
    double maximum(std::size_t n, const Function& f) {
        return reduce(MaximumOf{n, f})[0];
    }

    template <class Function>
    double sum(std::size_t n, const Function& f) {
        return reduce(SumOf{n, f})[0];
    }

    void exclusive_scan(DeviceArray<std::int32_t>& counts) {
        use();
        with_scratch([&](void* scratch, std::size_t& bytes) {
            return cub::DeviceScan::ExclusiveSum(scratch, bytes, counts.data(), counts.data(), counts.size(), stream_);
        });
    }

    std::vector<std::int32_t> picked(const DeviceArray<std::int32_t>& array, std::size_t first, std::size_t stride,
                                     std::size_t count) {
        use();
        constexpr std::size_t width = sizeof(std::int32_t);
        std::vector<std::int32_t> entries(count);
        if (stride == 0) {
            move(entries.data(), array.data() + first, width, cudaMemcpyDeviceToHost);
            wait();
            std::fill(entries.begin(), entries.end(), entries.front());
            return entries;
        }
        check_cuda(cudaMemcpy2DAsync(entries.data(), width, array.data() + first, stride * width, width, count,
                                     cudaMemcpyDeviceToHost, stream_),
                   "copying");
        wait();
        return entries;
    }

    void sorted_order(const DeviceArray<std::uint64_t>& keys, std::uint64_t bound, DeviceArray<std::int32_t>& order) {
        use();
        const std::size_t n = keys.size();
        order.resize(n);
        sorted_wide_.resize(n);
        number(n);
        with_scratch([&](void* scratch, std::size_t& bytes) {
            return cub::DeviceRadixSort::SortPairs(scratch, bytes, keys.data(), sorted_wide_.data(), numbers_.data(),
                                                   order.data(), n, 0, significant_bits(bound), stream_);
        });
    }

    template <class Bucket>
    void group(std::size_t n, std::size_t buckets, const Bucket& bucket, DeviceArray<std::int32_t>& begin,
               DeviceArray<std::int32_t>& entries) {
        use();
        keys_.resize(n);
        sorted_.resize(n);
        entries.resize(n);
        begin.resize(buckets + 1);
        number(n);
        for_each(n, kernels::Keys<Bucket>{bucket, keys_.data()});
        with_scratch([&](void* scratch, std::size_t& bytes) {
            return cub::DeviceRadixSort::SortPairs(scratch, bytes, keys_.data(), sorted_.data(), numbers_.data(),
                                                   entries.data(), n, 0, significant_bits(buckets), stream_);
        });
        launch(kernels::first_of_each<std::uint32_t>, buckets + 1, static_cast<const std::uint32_t*>(sorted_.data()), n,
               begin.data(), buckets + 1);
    }

    template <class End, class Body>
    void repeat(std::int64_t count, const End&, const Body& body) {
        use();
        // A kernel is loaded when it is first started, which must not happen while steps are being recorded.
        if (!loaded_ && count > 0) {
            body();
            loaded_ = true;
            --count;
        }
        for (const Launch& launch : plan_launches(count)) {
            const cudaGraphExec_t graph = graphs_.of(launch.steps, stream_, body);
            for (std::int64_t k = 0; k < launch.times; ++k)
                check_cuda(cudaGraphLaunch(graph, stream_), "starting recorded steps");
        }
    }

    template <class Loop>
    void run(const Loop& loop) {
        if (loop.capacity > 0) launch(kernels::guarded<Loop>, loop.capacity, loop);
    }

    template <class Loop, class End>
    void run_last(const Loop& loop, const End& end) {
        launch(kernels::guarded_last<Loop, End>, loop.capacity, loop, end, ticket_.data());
    }

private:
    static constexpr std::size_t most_reductions = 8;  ///< of one call
    static constexpr unsigned maximum_blocks = 1024;   ///< of a reduction: as many as a device runs at the same time

    static kernels::ReductionParts<> reduction_parts(unsigned, std::size_t, double*) { return {}; }
    template <class First, class... Rest>
    kernels::ReductionParts<First, Rest...> reduction_parts(unsigned blocks, std::size_t number, double* partial,
                                                            const First& first, const Rest&... rest) {
        return {{first, partial, results_.data() + number, ticket_.data() + 1 + number},
                reduction_parts(blocks, number + 1, partial + kernels::partial_size(first, blocks), rest...)};
    }

    template <class... Parameters, class... Arguments>
    void launch(void (*kernel)(Parameters...), std::size_t threads, const Arguments&... arguments) {
        launch_grid(kernel, dim3(block_count(threads, kernels::block_size)), arguments...);
    }

    template <class... Parameters, class... Arguments>
    void launch_grid(void (*kernel)(Parameters...), dim3 grid, const Arguments&... arguments) {
        cudaLaunchConfig_t config{};
        config.gridDim = grid;
        config.blockDim = dim3(kernels::block_size);
        config.stream = stream_;
        check_cuda(cudaLaunchKernelEx(&config, kernel, arguments...), "starting a loop");
    }

    void move(void* to, const void* from, std::size_t bytes, cudaMemcpyKind kind) {
        if (bytes > 0) check_cuda(cudaMemcpyAsync(to, from, bytes, kind, stream_), "copying");
    }

    /// Calls f(memory, bytes) twice, to learn how much it needs and to run it.
    template <class Function>
    void with_scratch(const Function& f) {
        std::size_t bytes = 0;
        check_cuda(f(nullptr, bytes), "sorting");
        scratch_.resize(std::max<std::size_t>(bytes, 1));
        check_cuda(f(scratch_.data(), bytes), "sorting");
    }

    /// 0, 1, 2, ... n - 1
    void number(std::size_t n) {
        if (numbers_.size() >= n) return;
        numbers_.resize(n);
        for_each(n, kernels::Count{numbers_.data()});
    }

    /// Every function begins with it: threads, and spaces on one thread, take turns.
    void use() const {
        check_cuda(cudaSetDevice(device_), "choosing the device");
        current_allocations() = allocations_;
    }
    void wait() const { check_cuda(cudaStreamSynchronize(stream_), "waiting for the device"); }

    int device_;
    cudaStream_t stream_ = nullptr;
    Allocations allocations_ = std::make_shared<std::uint64_t>(0);
    CudaGraphs graphs_{allocations_};
    bool loaded_ = false;
    DeviceArray<unsigned> ticket_;  ///< of the last loop of a step, and of reductions
    DeviceArray<double> partial_;
    PinnedArray<double> results_{most_reductions};
    DeviceArray<std::uint64_t> sorted_wide_;
    DeviceArray<std::uint32_t> keys_, sorted_;
    DeviceArray<std::int32_t> numbers_;
    DeviceArray<char> scratch_;
};

}  // namespace recoat
