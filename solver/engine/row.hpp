#pragma once

#include <cstddef>

#include "common/vec3.hpp"

namespace recoat {

/// Four doubles that are loaded together.
struct Row {
    double x = 0, y = 0, z = 0, w = 0;

    RECOAT_HD Vec3 xyz() const { return {x, y, z}; }
    RECOAT_HD void set(Vec3 v) {
        x = v.x;
        y = v.y;
        z = v.z;
    }
};

RECOAT_HD Row row(Vec3 v, double w = 0) { return {v.x, v.y, v.z, w}; }

/// Reads a struct of doubles from an array. A device does so 16 bytes at a time, for which its arrays are aligned.
template <class T, class Index>
RECOAT_HD T load(const T* array, Index at) {
#ifdef __CUDA_ARCH__
    static_assert(sizeof(T) % sizeof(double2) == 0);
    T value;
    const auto* from = reinterpret_cast<const double2*>(array + at);
#pragma unroll
    for (std::size_t k = 0; k < sizeof(T) / sizeof(double2); ++k) {
        const double2 part = from[k];
        memcpy(reinterpret_cast<double*>(&value) + 2 * k, &part, sizeof part);
    }
    return value;
#else
    return array[at];
#endif
}

/// Writes it likewise.
template <class T, class Index>
RECOAT_HD void store(T* array, Index at, const T& value) {
#ifdef __CUDA_ARCH__
    static_assert(sizeof(T) % sizeof(double2) == 0);
    auto* to = reinterpret_cast<double2*>(array + at);
#pragma unroll
    for (std::size_t k = 0; k < sizeof(T) / sizeof(double2); ++k) {
        double2 part;
        memcpy(&part, reinterpret_cast<const double*>(&value) + 2 * k, sizeof part);
        to[k] = part;
    }
#else
    array[at] = value;
#endif
}

}  // namespace recoat
