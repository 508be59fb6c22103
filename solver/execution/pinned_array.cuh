#pragma once

#include <cstddef>

#include "solver/execution/cuda_error.cuh"

namespace recoat {

/// Memory of the host that a device can write to: what a kernel leaves there needs no copy, only a wait.
template <class T>
class PinnedArray {
public:
    explicit PinnedArray(std::size_t n) {
        check_cuda(cudaMallocHost(&data_, n * sizeof(T)), "taking memory of the host");
    }
    PinnedArray(const PinnedArray&) = delete;
    PinnedArray& operator=(const PinnedArray&) = delete;
    ~PinnedArray() { cudaFreeHost(data_); }

    [[nodiscard]] T* data() { return data_; }

private:
    T* data_ = nullptr;
};

}  // namespace recoat
