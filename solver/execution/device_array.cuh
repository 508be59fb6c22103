#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <utility>

#include "solver/execution/cuda_error.cuh"
#include "solver/execution/launch_plan.hpp"

namespace recoat {

/// Counts allocations of device memory: what was captured with the addresses before one must be captured again.
inline std::atomic<std::uint64_t>& device_allocations() {
    static std::atomic<std::uint64_t> count{0};
    return count;
}

/// Memory of the current device. It grows and never shrinks; what it held is lost when it grows.
template <class T>
class DeviceArray {
public:
    DeviceArray() = default;
    DeviceArray(DeviceArray&& other) noexcept { swap(other); }
    DeviceArray& operator=(DeviceArray&& other) noexcept {
        swap(other);
        return *this;
    }
    ~DeviceArray() { cudaFree(data_); }

    void resize(std::size_t n) {
        if (n > capacity_) {
            check_cuda(cudaFree(data_), "giving memory back");
            data_ = nullptr;
            capacity_ = 0;
            const std::size_t wanted = grown_capacity(n);
            check_cuda(cudaMalloc(&data_, wanted * sizeof(T)), "taking memory");
            capacity_ = wanted;
            ++device_allocations();
        }
        size_ = n;
    }

    [[nodiscard]] T* data() { return data_; }
    [[nodiscard]] const T* data() const { return data_; }
    [[nodiscard]] std::size_t size() const { return size_; }
    [[nodiscard]] std::size_t capacity() const { return capacity_; }
    [[nodiscard]] bool empty() const { return size_ == 0; }

private:
    void swap(DeviceArray& other) noexcept {
        std::swap(data_, other.data_);
        std::swap(size_, other.size_);
        std::swap(capacity_, other.capacity_);
    }

    T* data_ = nullptr;
    std::size_t size_ = 0, capacity_ = 0;
};

}  // namespace recoat
