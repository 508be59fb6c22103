#pragma once

#include <stdexcept>
#include <string>

#include <cuda_runtime.h>

#include "common/error.hpp"

namespace recoat {

/// Throws what a failed call means: InputError when the device's memory is too small, or else a bug.
inline void check_cuda(cudaError_t error, const char* doing) {
    if (error == cudaSuccess) return;
    cudaGetLastError();  // or the next call would report it again
    if (error == cudaErrorMemoryAllocation)
        throw InputError(std::string("the CUDA device has too little free memory (") + doing +
                         "): use fewer particles, another device, or --backend cpu");
    if (error == cudaErrorNoKernelImageForDevice)
        throw InputError(
            "this program has no code for the CUDA device: build it with the device's architecture in "
            "RECOAT_CUDA_ARCHITECTURES, or use --backend cpu");
    throw std::runtime_error(std::string("CUDA, ") + doing + ": " + cudaGetErrorString(error));
}

}  // namespace recoat
