#pragma once

#include <optional>
#include <string>
#include <vector>

#include "analyzer/analysis.hpp"

namespace recoat {

/// One number of a layer in its voxel form at several resolutions beside the exact one.
struct ConvergenceQuantity {
    std::string name, unit;
    double exact = 0;
    std::vector<double> voxel;  ///< one for each resolution
    std::optional<double>
        order;  ///< p of |voxel - exact| ~ n^-p, least squares of the logarithms; needs two errors above 0
    std::optional<int> enough;        ///< smallest resolution from which on the error stays within the tolerance
    std::optional<double> projected;  ///< where there is none: where the order would reach it

    [[nodiscard]] double error(std::size_t index) const { return voxel[index] - exact; }
};

struct Convergence {
    std::vector<int> voxels_per_dp;  ///< ascending
    double tolerance = 0;            ///< of errors, as a share of the exact value; absolute where that is 0
    std::vector<ConvergenceQuantity> quantities;

    /// Smallest resolution that is enough for every quantity.
    [[nodiscard]] std::optional<int> enough() const;
};

/// Compares the voxel forms of an analysis, whose resolutions ascend, with its exact ones: packing density (also the
/// root mean square of its node errors, of which the share is taken of the mean density), height, density pores,
/// chamber pores by rule P of at least 0.5 d_p (not for unequal radii); not what is undefined in the exact form.
[[nodiscard]] Convergence convergence(const Analysis& analysis, double tolerance);

/// Order and sufficient resolution of one quantity; fills in `order`, `enough` and `projected`.
void judge(ConvergenceQuantity& quantity, const std::vector<int>& voxels_per_dp, double tolerance, double scale);

}  // namespace recoat
