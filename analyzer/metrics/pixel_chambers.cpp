#include "analyzer/metrics/pixel_chambers.hpp"

#include "analyzer/fields/pixel_distance.hpp"
#include "analyzer/fields/pixel_maxima.hpp"

namespace recoat {

PoreSizes pixel_chamber_sizes(const Layer& layer, const AnalysisConfig& config, int pixels_per_dp) {
    // Beyond the region as far as the widest chambers of usual layers reach.
    constexpr double margin = 3;
    const double n = pixels_per_dp;
    const PixelDistance pixels = pixel_distance(layer, pixels_per_dp, margin);
    std::vector<double> diameters;
    for (const PixelMaximum& maximum : pixel_maxima(pixels, config.chamber_persistence * n)) {
        const double x = (pixels.i_begin + maximum.i + 0.5) / n, diameter = 2 * maximum.distance / n;
        const bool inside =
            config.chamber_x_edge == ChamberEdge::inside
                ? x - diameter / 2 >= -config.bin_tol && x + diameter / 2 <= layer.length + config.bin_tol
                : x >= -config.bin_tol && x < layer.length - config.bin_tol;
        if (inside && diameter >= config.chamber_min_diameter) diameters.push_back(diameter);
    }
    return pore_sizes(std::move(diameters), config.bin_tol);
}

}  // namespace recoat
