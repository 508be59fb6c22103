#pragma once

/// RECOAT_HD marks a function that both the host and a CUDA device can run, RECOAT_LAMBDA a lambda likewise;
/// RECOAT_UNROLL unrolls the short loop that follows, without which g++ does not make vectors of the loop around it.
#ifdef __CUDACC__
#define RECOAT_LAMBDA __host__ __device__
#define RECOAT_HD __host__ __device__ __forceinline__
#else
#define RECOAT_LAMBDA
#define RECOAT_HD inline __attribute__((always_inline))
#endif
#if defined(__CUDA_ARCH__)
#define RECOAT_UNROLL _Pragma("unroll")
#define RECOAT_UNROLL_ALL _Pragma("unroll")
#elif defined(__CUDACC__)
#define RECOAT_UNROLL
#define RECOAT_UNROLL_ALL
#else
#define RECOAT_UNROLL _Pragma("GCC unroll 8")
#define RECOAT_UNROLL_ALL _Pragma("GCC unroll 16")
#endif
