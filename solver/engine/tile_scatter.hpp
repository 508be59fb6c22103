#pragma once

#include "solver/engine/tile_work.hpp"
#include "solver/execution/simd.hpp"

namespace recoat {

/// Adds rows to the sums of the partners of one pack of contacts, contact by contact in their order.
template <class Set, class Variant>
struct TileScatter {
    using S = Simd<Set>;
    using Row = typename S::Row;
    static constexpr int size = SumLayout<Variant>::size;

    double* sums;  ///< as TileWork::sums

    RECOAT_HD double* at(std::int32_t place) const { return sums + size * std::size_t(place); }
    static RECOAT_HD void add(double* sum, Row row) { S::store(sum, S::add(S::row(sum), row)); }
    static RECOAT_HD void add(double* sum, Row row, Row factor) {
        S::store(sum, S::multiply_add(row, factor, S::row(sum)));
    }
};

}  // namespace recoat
