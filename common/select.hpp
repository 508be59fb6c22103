#pragma once

#include "common/host_device.hpp"

namespace recoat {

// A law is written once for numbers and for packs of numbers. A pack's comparison is a mask and its choice a function
// `select(mask, a, b)`, which the library of packs brings; these are the same for numbers.

RECOAT_HD double select(bool condition, double a, double b) { return condition ? a : b; }
RECOAT_HD float select(bool condition, float a, float b) { return condition ? a : b; }

/// Whether a condition holds for any number of a pack.
RECOAT_HD bool any(bool condition) { return condition; }

/// The smaller and the larger of two numbers. Packs have instructions for that (solver/execution/simd_rows.hpp).
template <class T>
struct Order {
    static RECOAT_HD T smaller(T a, T b) { return select(b < a, b, a); }
    static RECOAT_HD T larger(T a, T b) { return select(a < b, b, a); }
};

template <class T>
RECOAT_HD T smaller(T a, T b) {
    return Order<T>::smaller(a, b);
}

template <class T>
RECOAT_HD T larger(T a, T b) {
    return Order<T>::larger(a, b);
}

template <class T>
RECOAT_HD T clamped(T x, T lower, T upper) {
    return smaller(larger(x, lower), upper);
}

}  // namespace recoat
