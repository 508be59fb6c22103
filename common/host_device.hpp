#pragma once

/// Marks a function that both the host and a CUDA device can run.
#ifdef __CUDACC__
#define RECOAT_HD __host__ __device__ __forceinline__
#else
#define RECOAT_HD inline __attribute__((always_inline))
#endif
