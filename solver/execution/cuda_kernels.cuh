#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>

namespace recoat::kernels {

inline constexpr unsigned block_size = 128;
inline constexpr unsigned warp_size = 32;
/// Blocks of the last loop that a multiprocessor takes at least: told less, the compiler spills some registers.
inline constexpr unsigned last_blocks = 6;

__device__ inline std::size_t thread_number() {
    return static_cast<std::size_t>(blockIdx.x) * blockDim.x + threadIdx.x;
}

/// Largest value of a block, in its first thread; not-a-number counts for nothing, as on the host.
__device__ inline double block_maximum(double value) {
    __shared__ double of_warp[block_size / warp_size];
    if (value != value) value = -std::numeric_limits<double>::infinity();
    for (unsigned half = warp_size / 2; half > 0; half /= 2) {
        const double other = __shfl_down_sync(0xffffffffU, value, half);
        value = other > value ? other : value;
    }
    if (threadIdx.x % warp_size == 0) of_warp[threadIdx.x / warp_size] = value;
    __syncthreads();
    if (threadIdx.x == 0)
        for (unsigned w = 1; w < block_size / warp_size; ++w) value = of_warp[w] > value ? of_warp[w] : value;
    return value;
}

/// Raises `peak` to `value` if that is larger; neither is negative, so that their bits compare as they do. A maximum
/// does not depend on the order in which it is taken.
__device__ inline void raise(double* peak, double value) {
    if (value > 0)
        atomicMax(reinterpret_cast<unsigned long long*>(peak),
                  static_cast<unsigned long long>(__double_as_longlong(value)));
}

template <class Function>
__global__ void __launch_bounds__(block_size) each(Function f, std::size_t n) {
    const std::size_t k = thread_number();
    if (k < n) f(k);
}

template <class T>
__global__ void __launch_bounds__(block_size) fill(T* array, std::size_t n, T value) {
    const std::size_t k = thread_number();
    if (k < n) array[k] = value;
}

/// Loop bodies of the sorting itself.
template <class Bucket>
struct Keys {
    Bucket bucket;
    std::uint32_t* key;
    __device__ void operator()(std::size_t k) const { key[k] = static_cast<std::uint32_t>(bucket(k)); }
};
struct Count {
    std::int32_t* number;
    __device__ void operator()(std::size_t k) const { number[k] = static_cast<std::int32_t>(k); }
};

/// First place of each bucket among sorted keys.
template <class Key>
__global__ void __launch_bounds__(block_size)
    first_of_each(const Key* keys, std::size_t n, std::int32_t* begin, std::size_t count) {
    const std::size_t bucket = thread_number();
    if (bucket >= count) return;
    std::size_t lower = 0, upper = n;
    while (lower < upper) {
        const std::size_t middle = (lower + upper) / 2;
        if (keys[middle] < bucket)
            lower = middle + 1;
        else
            upper = middle;
    }
    begin[bucket] = static_cast<std::int32_t>(lower);
}

/// A guarded loop of a step, one thread each.
template <class Loop>
__global__ void __launch_bounds__(block_size) guarded(Loop loop) {
    if (!loop.open()) return;
    const std::size_t k = thread_number();
    double value = k < loop.size() ? loop(k) : 0;
    if constexpr (Loop::measures) {
        value = block_maximum(value);
        if (threadIdx.x == 0) raise(loop.peak, value);
    }
}

/// The last loop of a step, and then, in the block that is done last, its end. The loop may be closed, because an
/// earlier one found a fault, which the end then notes.
template <class Loop, class End>
__global__ void __launch_bounds__(block_size, last_blocks) guarded_last(Loop loop, End end, unsigned* ticket) {
    if (!end.running()) return;
    const std::size_t k = thread_number();
    double value = k < loop.size() && loop.open() ? loop(k) : 0;
    if constexpr (Loop::measures) {
        value = block_maximum(value);
        if (threadIdx.x == 0) raise(loop.peak, value);
    }
    if (threadIdx.x == 0) {
        __threadfence();
        if (atomicInc(ticket, gridDim.x - 1) == gridDim.x - 1) {
            __threadfence();
            end();
        }
    }
}

}  // namespace recoat::kernels
