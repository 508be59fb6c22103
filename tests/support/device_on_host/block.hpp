#pragma once

#include <cstdint>
#include <functional>

// What a kernel sees of its threads.

struct dim3 {
    unsigned x = 1, y = 1, z = 1;
    dim3(unsigned along = 1, unsigned across = 1, unsigned up = 1) : x(along), y(across), z(up) {}
    [[nodiscard]] unsigned count() const { return x * y * z; }
};

extern thread_local dim3 threadIdx, blockIdx, blockDim, gridDim;

/// Calls `thread` once for every thread of block `number` of a grid, in lockstep between barriers, on this thread of
/// the host. Several threads of the host may each run a block at the same time.
void run_block(unsigned number, dim3 grid, dim3 block, const std::function<void()>& thread);

void __syncthreads();
double __shfl_down_sync(unsigned mask, double value, unsigned distance);
/// Orders writes before it and what other threads see of them: without it, atomic operations order nothing here.
inline void __threadfence() {
    static unsigned fences = 0;
    __atomic_fetch_add(&fences, 1, __ATOMIC_ACQ_REL);
}

inline long long __double_as_longlong(double value) {
    long long bits;
    __builtin_memcpy(&bits, &value, sizeof bits);
    return bits;
}
inline unsigned long long atomicMax(unsigned long long* place, unsigned long long value) {
    unsigned long long before = __atomic_load_n(place, __ATOMIC_RELAXED);
    while (value > before &&
           !__atomic_compare_exchange_n(place, &before, value, false, __ATOMIC_RELAXED, __ATOMIC_RELAXED)) {
    }
    return before;
}
inline unsigned atomicInc(unsigned* place, unsigned last) {
    unsigned before = __atomic_load_n(place, __ATOMIC_RELAXED);
    while (!__atomic_compare_exchange_n(place, &before, before >= last ? 0 : before + 1, false, __ATOMIC_RELAXED,
                                        __ATOMIC_RELAXED)) {
    }
    return before;
}
