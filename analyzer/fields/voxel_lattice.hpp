#pragma once

#include <cmath>
#include <cstdint>

#include "analyzer/division.hpp"

namespace recoat {

/// Voxels over a layer: their lower corners lie at whole numbers of sides from the start of the region, y_min and the
/// base. The sides along x and y are the nearest to 1/n that fit into the region and into the period a whole number of
/// times; along z, where nothing has to fit, the side is 1/n.
struct VoxelLattice {
    int n = 1;                               ///< nominal number per d_p
    std::int64_t rows = 0, columns = 0;      ///< number along x in the region, and along y in a period
    double per_x = 1, per_y = 1, per_z = 1;  ///< voxels per d_p

    /// @param length, width of the region along x and of the period along y [d_p]
    VoxelLattice(double length, double width, int voxels_per_dp) : n(voxels_per_dp) {
        const Division x = divide(length * n), y = divide(width * n);
        rows = static_cast<std::int64_t>(x.count);
        columns = static_cast<std::int64_t>(y.count);
        per_x = n / x.stretch;
        per_y = n / y.stretch;
        per_z = n;
    }
};

}  // namespace recoat
