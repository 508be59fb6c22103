#pragma once

// Stands in for the CUDA runtime in tests: "device" memory is host memory filled with not-a-number, kernels run thread
// by thread on the host, barriers and shuffles included. What it shows is that launches, copies, captured steps and
// kernels do what they should; what it cannot show is anything about many threads at the same time, or speed.

#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <functional>
#include <tuple>
#include <utility>
#include <vector>

#include "tests/support/device_on_host/block.hpp"

#define __global__
#define __device__
#define __host__
#define __shared__ static
#define __launch_bounds__(...)

enum cudaError_t {
    cudaSuccess,
    cudaErrorMemoryAllocation,
    cudaErrorStreamCaptureUnsupported,
    cudaErrorNoKernelImageForDevice,
    cudaErrorNoDevice,
    cudaErrorInsufficientDriver
};
enum cudaMemcpyKind { cudaMemcpyHostToDevice, cudaMemcpyDeviceToHost, cudaMemcpyDeviceToDevice };
enum cudaStreamCaptureMode { cudaStreamCaptureModeThreadLocal };
constexpr unsigned cudaStreamNonBlocking = 1;

using Recording = std::vector<std::function<void()>>;
struct HostStream {
    bool recording = false;
    Recording recorded;
};
using cudaStream_t = HostStream*;
using cudaGraph_t = Recording*;
using cudaGraphExec_t = Recording*;

struct cudaDeviceProp {
    char name[256] = "the host as a device";
    std::size_t totalGlobalMem = std::size_t{1} << 30;
    int major = 8, minor = 0;
};
struct cudaLaunchConfig_t {
    dim3 gridDim, blockDim;
    std::size_t dynamicSmemBytes = 0;
    cudaStream_t stream = nullptr;
};

inline const char* cudaGetErrorString(cudaError_t) { return "an error of the device on the host"; }
inline cudaError_t cudaGetLastError() { return cudaSuccess; }
inline cudaError_t cudaGetDeviceCount(int* count) { return *count = 1, cudaSuccess; }
inline cudaError_t cudaGetDeviceProperties(cudaDeviceProp* properties, int) {
    return *properties = cudaDeviceProp{}, cudaSuccess;
}
inline cudaError_t cudaSetDevice(int device) { return device == 0 ? cudaSuccess : cudaErrorNoDevice; }

template <class T>
cudaError_t cudaMalloc(T** data, std::size_t bytes) {
    *data = static_cast<T*>(std::malloc(bytes));
    if (*data == nullptr) return cudaErrorMemoryAllocation;
    std::memset(static_cast<void*>(*data), 0xff, bytes);
    return cudaSuccess;
}
inline cudaError_t cudaFree(void* data) { return std::free(data), cudaSuccess; }

inline cudaError_t cudaStreamCreateWithFlags(cudaStream_t* stream, unsigned) {
    return *stream = new HostStream, cudaSuccess;
}
inline cudaError_t cudaStreamDestroy(cudaStream_t stream) { return delete stream, cudaSuccess; }
inline cudaError_t cudaStreamSynchronize(cudaStream_t stream) {
    return stream->recording ? cudaErrorStreamCaptureUnsupported : cudaSuccess;
}
inline cudaError_t cudaMemcpyAsync(void* to, const void* from, std::size_t bytes, cudaMemcpyKind, cudaStream_t stream) {
    if (stream->recording) return cudaErrorStreamCaptureUnsupported;
    return std::memmove(to, from, bytes), cudaSuccess;
}
inline cudaError_t cudaMemcpy2DAsync(void* to, std::size_t to_pitch, const void* from, std::size_t from_pitch,
                                     std::size_t width, std::size_t height, cudaMemcpyKind, cudaStream_t) {
    for (std::size_t row = 0; row < height; ++row)
        std::memcpy(static_cast<char*>(to) + row * to_pitch, static_cast<const char*>(from) + row * from_pitch, width);
    return from_pitch < width ? cudaErrorNoDevice : cudaSuccess;
}

inline cudaError_t cudaStreamBeginCapture(cudaStream_t stream, cudaStreamCaptureMode) {
    stream->recording = true;
    stream->recorded.clear();
    return cudaSuccess;
}
inline cudaError_t cudaStreamEndCapture(cudaStream_t stream, cudaGraph_t* graph) {
    stream->recording = false;
    *graph = new Recording(std::move(stream->recorded));
    return cudaSuccess;
}
inline cudaError_t cudaGraphInstantiate(cudaGraphExec_t* made, cudaGraph_t graph, unsigned) {
    return *made = new Recording(*graph), cudaSuccess;
}
inline cudaError_t cudaGraphDestroy(cudaGraph_t graph) { return delete graph, cudaSuccess; }
inline cudaError_t cudaGraphExecDestroy(cudaGraphExec_t graph) { return delete graph, cudaSuccess; }
inline cudaError_t cudaGraphLaunch(cudaGraphExec_t graph, cudaStream_t) {
    for (const auto& kernel : *graph) kernel();
    return cudaSuccess;
}

template <class... Parameters, class... Arguments>
cudaError_t cudaLaunchKernelEx(const cudaLaunchConfig_t* config, void (*kernel)(Parameters...),
                               const Arguments&... arguments) {
    const std::tuple<Parameters...> values(arguments...);
    const dim3 grid = config->gridDim, block = config->blockDim;
    const auto run = [=] { run_kernel(grid, block, [&] { std::apply(kernel, values); }); };
    if (config->stream->recording)
        config->stream->recorded.emplace_back(run);
    else
        run();
    return cudaSuccess;
}
