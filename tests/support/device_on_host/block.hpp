#pragma once

#include <cstdint>
#include <functional>

// What a kernel sees of its threads.

struct dim3 {
    unsigned x = 1, y = 1, z = 1;
    dim3(unsigned along = 1) : x(along) {}
};

extern thread_local dim3 threadIdx, blockIdx, blockDim, gridDim;

/// Calls `thread` once for every thread of every block, in lockstep between barriers.
void run_kernel(dim3 grid, dim3 block, const std::function<void()>& thread);

void __syncthreads();
double __shfl_down_sync(unsigned mask, double value, unsigned distance);
inline void __threadfence() {}

inline long long __double_as_longlong(double value) {
    long long bits;
    __builtin_memcpy(&bits, &value, sizeof bits);
    return bits;
}
inline unsigned long long atomicMax(unsigned long long* place, unsigned long long value) {
    const unsigned long long before = *place;
    if (value > before) *place = value;
    return before;
}
inline unsigned atomicInc(unsigned* place, unsigned last) {
    const unsigned before = *place;
    *place = before >= last ? 0 : before + 1;
    return before;
}
