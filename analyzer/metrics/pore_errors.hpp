#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "analyzer/fields/map.hpp"
#include "analyzer/fields/top_view.hpp"

namespace recoat {

/// How the pores of a pixel form differ from the exact ones.
struct PoreErrors {
    std::size_t matched = 0;
    std::size_t missed = 0;    ///< exact pores without a partner
    std::size_t spurious = 0;  ///< pixel pores without a partner
    /// Diameter in pixels minus exact diameter, over the matched ones [d_p]; none without such.
    struct Size {
        double bias = 0, deviation = 0;  ///< mean and standard deviation
    };
    std::optional<Size> size;
};

/// Circles are partners when their centres are within `reach`, nearest images; the nearest pairs first, each circle
/// once.
[[nodiscard]] PoreErrors chamber_errors(const std::vector<Circle>& exact, const std::vector<Circle>& pixels,
                                        double period, double reach);

/// Pores of two maps of packing density, by 8 neighbours below `threshold`: partners are those of which each shares
/// more cells with the other than with any other pore. Diameter: of the circle of the same area. Maps of one size.
[[nodiscard]] PoreErrors density_pore_errors(const Map& exact, const Map& voxels, double threshold, double cell_area);

}  // namespace recoat
