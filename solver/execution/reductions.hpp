#pragma once

#include <cstddef>

#include "common/host_device.hpp"

namespace recoat {

// What a space can be asked for in one call of `reduce`.

/// Sum of f(k) for 0 <= k < n, in the order of OrderedSum.
template <class Function>
struct SumOf {
    std::size_t n;
    Function f;
};
template <class Function>
SumOf(std::size_t, Function) -> SumOf<Function>;

/// Largest f(k) for 0 <= k < n, or minus infinity; not-a-number counts for nothing.
template <class Function>
struct MaximumOf {
    std::size_t n;
    Function f;
};
template <class Function>
MaximumOf(std::size_t, Function) -> MaximumOf<Function>;

/// The entries of an array.
struct Entries {
    const double* value;
    RECOAT_HD double operator()(std::size_t k) const { return value[k]; }
};

template <class Array>
SumOf<Entries> sum_of_entries(const Array& array) {
    return {array.size(), {array.data()}};
}

}  // namespace recoat
