#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <utility>

#include "solver/execution/cuda_error.cuh"
#include "solver/execution/launch_plan.hpp"

namespace recoat {

/// Counts how often the arrays of one space have taken memory: what was captured with the addresses before one must be
/// captured again. Arrays and their space share it, and one thread at a time uses them.
using Allocations = std::shared_ptr<std::uint64_t>;

/// The count of the space that this thread used last.
inline Allocations& current_allocations() {
    static thread_local Allocations count = std::make_shared<std::uint64_t>(0);
    return count;
}

/// Memory of the current device. It grows and never shrinks; what it held is lost when it grows. It belongs to the
/// space that was in use when it first took some.
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
            if (!allocations_) allocations_ = current_allocations();
            ++*allocations_;
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
        std::swap(allocations_, other.allocations_);
    }

    T* data_ = nullptr;
    std::size_t size_ = 0, capacity_ = 0;
    Allocations allocations_;
};

}  // namespace recoat
