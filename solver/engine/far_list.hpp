#pragma once

#include <cstdint>
#include <vector>

#include "solver/engine/execution.hpp"
#include "solver/engine/particles.hpp"

namespace recoat {

/// Pairs that could come close for a while: every pair with separation below `skin`, found over cells.
/// Sorted by (first, second), first < second.
struct FarList {
    std::vector<std::size_t> begin;    ///< [N + 1] where each particle's partners start
    std::vector<std::int32_t> second;  ///< ascending within each particle

    void build(OpenMP& space, const std::vector<Row>& position, double skin, double y_min, double y_period);
};

/// Order in which particles of one cell, and neighbouring cells, lie together: new place -> old place.
std::vector<std::int32_t> spatial_order(const std::vector<Row>& position, const std::vector<std::int64_t>& id,
                                        double skin, double y_min, double y_period);

}  // namespace recoat
