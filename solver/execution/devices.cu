#include "solver/execution/cuda_error.cuh"
#include "solver/execution/devices.hpp"

namespace recoat {

namespace {

__global__ void nothing() {}

std::string words_of(cudaError_t error) {
    cudaGetLastError();  // or the next call would report it again
    return std::string("the driver says \"") + cudaGetErrorString(error) + "\" (" + cuda_versions_here() + ")";
}

Devices none(cudaError_t error) {
    int driver = 0;
    if (cudaDriverGetVersion(&driver) != cudaSuccess) driver = 0;
    if (error == cudaErrorNoDevice) return {{}, "the driver sees no device", false};
    if (error == cudaErrorInsufficientDriver && driver == 0) return {{}, "there is no driver", false};
    if (error == cudaErrorInsufficientDriver)
        return {{}, "the driver is older than this program needs (" + cuda_versions_here() + ")", true};
    return {{}, words_of(error), true};
}

cudaError_t run_nothing() {
    if (const cudaError_t error = cudaFree(nullptr); error != cudaSuccess) return error;
    cudaLaunchConfig_t config{};
    config.gridDim = config.blockDim = dim3(1);
    if (const cudaError_t error = cudaLaunchKernelEx(&config, nothing); error != cudaSuccess) return error;
    return cudaDeviceSynchronize();
}

}  // namespace

Devices cuda_devices() {
    int count = 0;
    const cudaError_t error = cudaGetDeviceCount(&count);
    if (error != cudaSuccess) cudaGetLastError();
    if (error != cudaSuccess || count == 0) return none(error == cudaSuccess ? cudaErrorNoDevice : error);
    Devices devices;
    for (int number = 0; number < count; ++number) {
        cudaDeviceProp properties{};
        const cudaError_t asked = cudaGetDeviceProperties(&properties, number);
        if (asked == cudaSuccess)
            devices.found.push_back(
                {properties.name, properties.totalGlobalMem, properties.major, properties.minor, ""});
        else
            devices.found.push_back({"", 0, 0, 0, words_of(asked)});  // it keeps its number
    }
    return devices;
}

std::string try_device(int number) {
    cudaError_t error = cudaSetDevice(number);
    if (error == cudaSuccess) error = run_nothing();
    if (error == cudaSuccess) return {};
    cudaGetLastError();  // or the next call would report it again
    return cuda_failure(static_cast<int>(error), cudaGetErrorString(error), "trying it", number, cuda_versions_here())
        .what;
}

}  // namespace recoat
