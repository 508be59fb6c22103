#pragma once

#include <algorithm>
#include <vector>

#include <cub/device/device_radix_sort.cuh>
#include <cub/device/device_scan.cuh>

#include "solver/execution/cuda_graphs.cuh"
#include "solver/execution/cuda_kernels.cuh"
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
        check_cuda(cudaSetDevice(device_), "choosing the device");
        check_cuda(cudaStreamCreateWithFlags(&stream_, cudaStreamNonBlocking), "making a stream");
        ticket_.resize(1);
        fill(ticket_, 1, 0U);
        partial_.resize(maximum_blocks);
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
        move(to.data(), from.data(), from.size() * sizeof(T), cudaMemcpyHostToDevice);
        wait();
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

    template <class Function>
    double maximum(std::size_t n, const Function& f) {
        use();
        std::vector<double> of_block(std::min<std::size_t>(maximum_blocks, block_count(n, kernels::block_size)));
        launch(kernels::maximum<Function>, of_block.size() * kernels::block_size, f, n, partial_.data());
        move(of_block.data(), partial_.data(), of_block.size() * sizeof(double), cudaMemcpyDeviceToHost);
        wait();
        return *std::max_element(of_block.begin(), of_block.end());
    }

    template <class Function>
    double sum(std::size_t n, const Function& f) {
        use();
        if (n == 0) return 0;
        std::size_t blocks = OrderedSum::blocks(n);
        sums_.resize(blocks);
        other_sums_.resize(blocks);
        launch(kernels::sum<Function>, blocks * kernels::warp_size, f, n, sums_.data());
        while (blocks > 1) {
            const kernels::Entries entries{sums_.data()};
            const std::size_t fewer = OrderedSum::blocks(blocks);
            launch(kernels::sum<kernels::Entries>, fewer * kernels::warp_size, entries, blocks, other_sums_.data());
            std::swap(sums_, other_sums_);
            blocks = fewer;
        }
        double total = 0;
        move(&total, sums_.data(), sizeof total, cudaMemcpyDeviceToHost);
        wait();
        return total;
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
    static constexpr std::size_t maximum_blocks = 512;

    template <class... Parameters, class... Arguments>
    void launch(void (*kernel)(Parameters...), std::size_t threads, const Arguments&... arguments) {
        cudaLaunchConfig_t config{};
        config.gridDim = dim3(block_count(threads, kernels::block_size));
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

    void use() const { check_cuda(cudaSetDevice(device_), "choosing the device"); }
    void wait() const { check_cuda(cudaStreamSynchronize(stream_), "waiting for the device"); }

    int device_;
    cudaStream_t stream_ = nullptr;
    CudaGraphs graphs_;
    bool loaded_ = false;
    DeviceArray<unsigned> ticket_;
    DeviceArray<double> partial_, sums_, other_sums_;
    DeviceArray<std::uint64_t> sorted_wide_;
    DeviceArray<std::uint32_t> keys_, sorted_;
    DeviceArray<std::int32_t> numbers_;
    DeviceArray<char> scratch_;
};

}  // namespace recoat
