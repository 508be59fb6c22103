#pragma once

#include <string>

#include <cuda_runtime.h>

#include "solver/execution/cuda_failure.hpp"

namespace recoat {

/// Versions of CUDA of this machine's driver and of this program, as part of a sentence.
inline std::string cuda_versions_here() {
    int driver = 0, runtime = 0;
    cudaDriverGetVersion(&driver);
    cudaRuntimeGetVersion(&runtime);
    return cuda_versions(driver, runtime);
}

/// What `error` means that came while `doing` something with the current device.
inline CudaFailure failure_of(cudaError_t error, const char* doing) {
    cudaGetLastError();  // or the next call would report it again
    int device = -1;
    if (cudaGetDevice(&device) != cudaSuccess) device = -1;
    return cuda_failure(static_cast<int>(error), cudaGetErrorString(error), doing, device, cuda_versions_here());
}

/// Throws what a failed call means [throw_failure].
inline void check_cuda(cudaError_t error, const char* doing) {
    if (error != cudaSuccess) throw_failure(failure_of(error, doing));
}

}  // namespace recoat
