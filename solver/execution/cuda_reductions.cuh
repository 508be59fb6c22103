#pragma once

#include "solver/execution/cuda_kernels.cuh"
#include "solver/execution/ordered_sum.hpp"
#include "solver/execution/reductions.hpp"

namespace recoat::kernels {

/// One of the reductions of a kernel.
template <class Reduction>
struct ReductionPart {
    Reduction of;
    double* partial;   ///< what its blocks have found: [partial_size(of, blocks)]
    double* result;    ///< in memory of the host
    unsigned* ticket;  ///< 0 before and after
};

/// The parts of a kernel; block (b, k) of the grid is block b of part k.
template <class... Reductions>
struct ReductionParts {};
template <class First, class... Rest>
struct ReductionParts<First, Rest...> {
    ReductionPart<First> first;
    ReductionParts<Rest...> rest;
};

/// Threads that have something to do in the first pass.
template <class Function>
std::size_t useful_threads(const SumOf<Function>& sum) {
    return OrderedSum::blocks(sum.n) * warp_size;
}
template <class Function>
std::size_t useful_threads(const MaximumOf<Function>& maximum) {
    return maximum.n;
}

template <class Function>
std::size_t partial_size(const SumOf<Function>& sum, unsigned) {
    std::size_t size = 0, count = sum.n;
    do size += count = OrderedSum::blocks(count);
    while (count > 1);
    return size;
}
template <class Function>
std::size_t partial_size(const MaximumOf<Function>&, unsigned blocks) {
    return blocks;
}

/// Sums of the blocks of OrderedSum, one warp each; `warp` of `warps` does every `warps`-th.
template <class Function>
__device__ void sum_blocks(const Function& f, std::size_t n, std::size_t warp, std::size_t warps, double* of_block) {
    static_assert(OrderedSum::lanes == warp_size);
    const unsigned lane = threadIdx.x % warp_size;
    for (std::size_t block = warp; block < OrderedSum::blocks(n); block += warps) {
        double value = OrderedSum::lane(f, block, lane, n);
        for (unsigned half = warp_size / 2; half > 0; half /= 2) value += __shfl_down_sync(0xffffffffU, value, half);
        if (lane == 0) of_block[block] = value;
    }
}

/// What every block does.
template <class Function>
__device__ void first_pass(const SumOf<Function>& sum, double* partial) {
    const std::size_t warps = static_cast<std::size_t>(gridDim.x) * (block_size / warp_size);
    sum_blocks(sum.f, sum.n, thread_number() / warp_size, warps, partial);
}
template <class Function>
__device__ void first_pass(const MaximumOf<Function>& maximum, double* partial) {
    double peak = -std::numeric_limits<double>::infinity();
    for (std::size_t k = thread_number(); k < maximum.n; k += static_cast<std::size_t>(gridDim.x) * block_size) {
        const double value = maximum.f(k);
        peak = value > peak ? value : peak;
    }
    peak = block_maximum(peak);
    if (threadIdx.x == 0) partial[blockIdx.x] = peak;
}

/// What the block does that is done last; the result is that of its first thread.
template <class Function>
__device__ double last_pass(const SumOf<Function>& sum, double* partial) {
    std::size_t count = OrderedSum::blocks(sum.n);
    while (count > 1) {
        sum_blocks(Entries{partial}, count, threadIdx.x / warp_size, block_size / warp_size, partial + count);
        __syncthreads();
        partial += count;
        count = OrderedSum::blocks(count);
    }
    return count == 0 ? 0 : *partial;
}
template <class Function>
__device__ double last_pass(const MaximumOf<Function>&, const double* partial) {
    double peak = -std::numeric_limits<double>::infinity();
    for (unsigned b = threadIdx.x; b < gridDim.x; b += block_size) peak = partial[b] > peak ? partial[b] : peak;
    return block_maximum(peak);
}

template <class Reduction>
__device__ void reduce_part(const ReductionPart<Reduction>& part) {
    __shared__ bool last;
    first_pass(part.of, part.partial);
    __threadfence();
    __syncthreads();
    if (threadIdx.x == 0) last = atomicInc(part.ticket, gridDim.x - 1) == gridDim.x - 1;
    __syncthreads();
    if (!last) return;
    __threadfence();
    const double value = last_pass(part.of, part.partial);
    if (threadIdx.x == 0) *part.result = value;
}

__device__ inline void reduce_number(unsigned, const ReductionParts<>&) {}
template <class First, class... Rest>
__device__ void reduce_number(unsigned number, const ReductionParts<First, Rest...>& parts) {
    if (number == 0)
        reduce_part(parts.first);
    else
        reduce_number(number - 1, parts.rest);
}

template <class... Reductions>
__global__ void __launch_bounds__(block_size) reduce(ReductionParts<Reductions...> parts) {
    reduce_number(blockIdx.y, parts);
}

}  // namespace recoat::kernels
