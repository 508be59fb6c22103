#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "analyzer/configuration.hpp"
#include "analyzer/fields/empty_circles.hpp"
#include "analyzer/fields/layer.hpp"
#include "analyzer/metrics/pore_sizes.hpp"

namespace recoat {

/// Chamber pores that a rule selects, from large to small. A chamber is a circle of the top view that touches disks all
/// round and overlaps none; its size is its diameter.
struct ChamberPores {
    PoreSizes sizes;
    std::vector<Circle> circles;      ///< from the start of the region and y_min [d_p]
    std::vector<double> persistence;  ///< of the circles, where the rule is about it [d_p]
};

/// Chamber pores of the region by each of the rules; the selection is made on the whole file.
struct ChamberPoreMetrics {
    ChamberPores all;                        ///< L: every local maximum of the gap
    ChamberPores separate;                   ///< A: from large to small, centre in none selected before
    ChamberPores disjoint;                   ///< B: from large to small, overlaps none selected before
    std::optional<ChamberPores> persistent;  ///< P: persistence at least chamber_persistence; for equal radii only
    std::size_t n_beyond_data = 0;           ///< of rule A, those that reach past the outermost centres along x
};

/// Smallest diameter of a chamber [d_p]: the circles between disks that touch or coincide but for round-off, and for
/// the digits of a file, are far below, and the hole between three touching spheres, 0.155 of their diameter, is far
/// above.
inline constexpr double smallest_chamber = 1e-3;

/// Whether a circle is a chamber of the region: large enough, and with its centre, or all of it, between the x ends.
[[nodiscard]] bool is_chamber(const Circle& circle, const Layer& layer, const AnalysisConfig& config);

[[nodiscard]] ChamberPoreMetrics chamber_pore_metrics(const Layer& layer, const AnalysisConfig& config);

}  // namespace recoat
