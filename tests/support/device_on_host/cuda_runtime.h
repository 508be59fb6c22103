#pragma once

// Stands in for the CUDA runtime in tests: "device" memory is host memory filled with not-a-number; a stream does its
// work on threads of its own while the host goes on, and runs several blocks of a kernel at the same time, each thread
// by thread, barriers and shuffles included. What it shows is that launches, copies, captured steps and kernels do what
// they should, and, with the thread sanitizer, that threads, blocks, streams and the host do not get in each other's
// way; what it cannot show is speed.

#include <atomic>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <functional>
#include <memory>
#include <tuple>
#include <utility>
#include <vector>

#include "tests/support/device_on_host/block.hpp"
#include "tests/support/device_on_host/stream.hpp"

#define __global__
#define __device__
#define __host__
#define __shared__ static thread_local
#define __launch_bounds__(...)

/// Numbers as in the real one.
enum cudaError_t {
    cudaSuccess = 0,
    cudaErrorMemoryAllocation = 2,
    cudaErrorInsufficientDriver = 35,
    cudaErrorDevicesUnavailable = 46,
    cudaErrorNoDevice = 100,
    cudaErrorInvalidDevice = 101,
    cudaErrorNoKernelImageForDevice = 209,
    cudaErrorECCUncorrectable = 214,
    cudaErrorIllegalAddress = 700,
    cudaErrorStreamCaptureUnsupported = 900
};
enum cudaMemcpyKind { cudaMemcpyHostToDevice, cudaMemcpyDeviceToHost, cudaMemcpyDeviceToDevice };
enum cudaStreamCaptureMode { cudaStreamCaptureModeThreadLocal };
constexpr unsigned cudaStreamNonBlocking = 1;

using cudaStream_t = HostStream*;
using cudaGraph_t = std::shared_ptr<Recording>*;
using cudaGraphExec_t = std::shared_ptr<Recording>*;

/// What tests see and set of the machine.
struct HostDevice {
    int count = 1;                                                    ///< devices
    int silent = -1;                                                  ///< one that does not tell its properties
    cudaError_t failure = cudaSuccess;                                ///< of everything that is done with a device
    std::atomic<std::uint64_t> recordings{0}, launches{0}, waits{0};  ///< made so far
};
inline HostDevice host_device;

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
inline cudaError_t cudaDriverGetVersion(int* version) { return *version = 13000, cudaSuccess; }
inline cudaError_t cudaRuntimeGetVersion(int* version) { return *version = 13000, cudaSuccess; }
inline cudaError_t cudaGetDeviceCount(int* count) { return *count = host_device.count, cudaSuccess; }
inline cudaError_t cudaGetDeviceProperties(cudaDeviceProp* properties, int device) {
    return *properties = cudaDeviceProp{}, device == host_device.silent ? cudaErrorInvalidDevice : cudaSuccess;
}
inline cudaError_t cudaSetDevice(int device) {
    return device < host_device.count ? host_device.failure : cudaErrorInvalidDevice;
}
inline cudaError_t cudaGetDevice(int* device) { return *device = 0, cudaSuccess; }
inline cudaError_t cudaDeviceSynchronize() { return wait_for_all_streams(), host_device.failure; }

template <class T>
cudaError_t cudaMalloc(T** data, std::size_t bytes) {
    *data = static_cast<T*>(std::malloc(bytes));
    if (*data == nullptr) return cudaErrorMemoryAllocation;
    std::memset(static_cast<void*>(*data), 0xff, bytes);
    return cudaSuccess;
}
inline cudaError_t cudaFree(void* data) {
    if (data != nullptr) wait_for_all_streams();
    return std::free(data), cudaSuccess;
}
template <class T>
cudaError_t cudaMallocHost(T** data, std::size_t bytes) {
    *data = static_cast<T*>(std::malloc(bytes));
    return *data == nullptr ? cudaErrorMemoryAllocation : cudaSuccess;
}
inline cudaError_t cudaFreeHost(void* data) { return cudaFree(data); }

inline cudaError_t cudaStreamCreateWithFlags(cudaStream_t* stream, unsigned) {
    return *stream = new HostStream, cudaSuccess;
}
inline cudaError_t cudaStreamDestroy(cudaStream_t stream) { return delete stream, cudaSuccess; }
inline cudaError_t cudaStreamSynchronize(cudaStream_t stream) {
    if (stream->recording) return cudaErrorStreamCaptureUnsupported;
    ++host_device.waits;
    return stream->wait(), cudaSuccess;
}

/// What the host hands over is taken at once, as from pageable memory; what it gets is there after it has waited, as in
/// pinned memory.
inline cudaError_t cudaMemcpyAsync(void* to, const void* from, std::size_t bytes, cudaMemcpyKind kind,
                                   cudaStream_t stream) {
    if (stream->recording) return cudaErrorStreamCaptureUnsupported;
    if (kind == cudaMemcpyHostToDevice) {
        const auto* first = static_cast<const char*>(from);
        stream->add([to, taken = std::vector<char>(first, first + bytes)](Crew&) {
            std::memcpy(to, taken.data(), taken.size());
        });
    } else {
        stream->add([=](Crew&) { std::memcpy(to, from, bytes); });
    }
    return cudaSuccess;
}
inline cudaError_t cudaMemcpy2DAsync(void* to, std::size_t to_pitch, const void* from, std::size_t from_pitch,
                                     std::size_t width, std::size_t height, cudaMemcpyKind, cudaStream_t stream) {
    stream->add([=](Crew&) {
        for (std::size_t row = 0; row < height; ++row)
            std::memcpy(static_cast<char*>(to) + row * to_pitch, static_cast<const char*>(from) + row * from_pitch,
                        width);
    });
    return from_pitch < width ? cudaErrorInvalidDevice : cudaSuccess;
}

inline cudaError_t cudaStreamBeginCapture(cudaStream_t stream, cudaStreamCaptureMode) {
    ++host_device.recordings;
    stream->recording = true;
    stream->recorded.clear();
    return cudaSuccess;
}
inline cudaError_t cudaStreamEndCapture(cudaStream_t stream, cudaGraph_t* graph) {
    stream->recording = false;
    *graph = new std::shared_ptr<Recording>(std::make_shared<Recording>(std::move(stream->recorded)));
    return cudaSuccess;
}
inline cudaError_t cudaGraphInstantiate(cudaGraphExec_t* made, cudaGraph_t graph, unsigned) {
    return *made = new std::shared_ptr<Recording>(*graph), cudaSuccess;
}
/// Of either kind.
inline cudaError_t cudaGraphDestroy(cudaGraph_t graph) { return delete graph, cudaSuccess; }
inline cudaError_t cudaGraphExecDestroy(cudaGraphExec_t graph) { return cudaGraphDestroy(graph); }
inline cudaError_t cudaGraphLaunch(cudaGraphExec_t graph, cudaStream_t stream) {
    stream->add([recording = *graph](Crew& crew) {
        for (const Work& kernel : *recording) kernel(crew);
    });
    return cudaSuccess;
}

template <class... Parameters, class... Arguments>
cudaError_t cudaLaunchKernelEx(const cudaLaunchConfig_t* config, void (*kernel)(Parameters...),
                               const Arguments&... arguments) {
    const std::tuple<Parameters...> values(arguments...);
    const dim3 grid = config->gridDim, block = config->blockDim;
    const Work run = [=](Crew& crew) { crew.run(grid, block, [&] { std::apply(kernel, values); }); };
    HostStream* stream = config->stream;
    ++host_device.launches;
    if (stream == nullptr) {
        Crew nobody(0);
        run(nobody);
    } else if (stream->recording) {
        stream->recorded.push_back(run);
    } else {
        stream->add(run);
    }
    return cudaSuccess;
}
