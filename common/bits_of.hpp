#pragma once

#include <bit>
#include <cstdint>

#include "common/host_device.hpp"

namespace recoat {

/// The bits of a number, or of each number of a pack, and back. Packs bring their own (solver/execution/simd_rows.hpp).
template <class T>
struct BitsOf;

template <>
struct BitsOf<double> {
    using Real = double;
    using Integer = std::uint64_t;
    static RECOAT_HD Integer of(double x) { return std::bit_cast<Integer>(x); }
    static RECOAT_HD double real(Integer bits) { return std::bit_cast<double>(bits); }
};

template <>
struct BitsOf<float> {
    using Real = float;
    using Integer = std::uint32_t;
    static RECOAT_HD Integer of(float x) { return std::bit_cast<Integer>(x); }
    static RECOAT_HD float real(Integer bits) { return std::bit_cast<float>(bits); }
};

}  // namespace recoat
