#include <cuda_runtime.h>

#include "solver/execution/devices.hpp"

namespace recoat {

namespace {

std::string problem_of(cudaError_t error) {
    if (error == cudaErrorNoDevice) return "the driver sees no device";
    if (error == cudaErrorInsufficientDriver) return "there is no driver, or it is older than this program needs";
    return std::string("the driver says \"") + cudaGetErrorString(error) + "\"";
}

}  // namespace

Devices cuda_devices() {
    Devices devices;
    int count = 0;
    const cudaError_t error = cudaGetDeviceCount(&count);
    if (error != cudaSuccess) {
        cudaGetLastError();  // or the next call would report it again
        devices.problem = problem_of(error);
        return devices;
    }
    for (int number = 0; number < count; ++number) {
        cudaDeviceProp properties{};
        if (cudaGetDeviceProperties(&properties, number) != cudaSuccess) continue;
        devices.found.push_back({properties.name, properties.totalGlobalMem, properties.major, properties.minor});
    }
    if (devices.found.empty()) devices.problem = problem_of(cudaErrorNoDevice);
    return devices;
}

}  // namespace recoat
