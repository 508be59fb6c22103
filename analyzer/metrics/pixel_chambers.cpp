#include "analyzer/metrics/pixel_chambers.hpp"

#include <cmath>

#include "analyzer/fields/pixel_maxima.hpp"

namespace recoat {

PixelChambers pixel_chambers(const Layer& layer, const AnalysisConfig& config, int pixels_per_dp) {
    // Beyond the region as far as the widest chambers of usual layers reach.
    constexpr double margin = 3;
    const double n = pixels_per_dp;
    const PixelRaster raster(layer, pixels_per_dp, margin);
    PixelChambers chambers;
    std::vector<double> diameters;
    for (const PixelMaximum& maximum : pixel_maxima(raster, config.chamber_persistence * n)) {
        const double x = raster.x(maximum.row), diameter = 2 * maximum.distance / n;
        const bool inside =
            config.chamber_x_edge == ChamberEdge::inside
                ? x - diameter / 2 >= -config.bin_tol && x + diameter / 2 <= layer.length + config.bin_tol
                : x >= -config.bin_tol && x < layer.length - config.bin_tol;
        if (!inside || diameter < config.chamber_min_diameter) continue;
        const double y = raster.y(maximum.column);
        chambers.circles.push_back({x, y - layer.width * std::floor(y / layer.width), diameter / 2});
        diameters.push_back(diameter);
    }
    chambers.sizes = pore_sizes(std::move(diameters), config.bin_tol);
    return chambers;
}

}  // namespace recoat
