#pragma once

#include <optional>

#include "analyzer/configuration.hpp"
#include "analyzer/fields/layer.hpp"

namespace recoat {

/// Amount of powder on the region.
struct TotalsMetrics {
    /// Packing density of a bed [paper eq. 14]: solid in z_min ... 0.9 z_max over that box, z_min the lowest and z_max
    /// the highest point of the region's spheres [-]. NaN where the box has no height.
    struct BedDensity {
        double clipped = 0;  ///< exact solid volume
        double centre = 0;   ///< whole spheres with their centre at or below 0.9 z_max
        double all = 0;      ///< every sphere with its centre in the region: the formula read literally
    };
    double volume_whole = 0;           ///< whole spheres with their centre in the region [m3]
    double volume_clipped = 0;         ///< exact solid between the two x ends of the region [m3]
    double area = 0;                   ///< [m2]
    double mass_per_area = 0;          ///< of the whole spheres [kg/m2]
    double mass_per_area_clipped = 0;  ///< of the exact solid [kg/m2]
    double layer_phi = 0;              ///< clipped volume over area x h_b [-]
    std::optional<BedDensity> bed;     ///< none without particles
};

[[nodiscard]] TotalsMetrics totals_metrics(const Layer& layer, const AnalysisConfig& config);

}  // namespace recoat
