#include "analyzer/metrics/pixel_chambers.hpp"

#include <cmath>

#include "analyzer/fields/pixel_maxima.hpp"
#include "analyzer/metrics/chamber_pores.hpp"

namespace recoat {

PixelChambers pixel_chambers(const Layer& layer, const AnalysisConfig& config, int pixels_per_dp) {
    // Beyond the region as far as the widest chambers of usual layers reach.
    constexpr double margin = 3;
    const double n = layer.voxels(pixels_per_dp).per_y;
    const PixelRaster raster(layer, n, margin);
    PixelChambers chambers;
    std::vector<double> diameters;
    for (const PixelMaximum& maximum : pixel_maxima(raster, config.chamber_persistence * n)) {
        const double y = raster.y(maximum.column), radius = maximum.distance / n;
        const Circle circle = {raster.x(maximum.row), y - layer.width * std::floor(y / layer.width), radius};
        if (!is_chamber(circle, layer, config)) continue;
        chambers.circles.push_back(circle);
        diameters.push_back(2 * radius);
    }
    chambers.sizes = pore_sizes(std::move(diameters), config.bin_tol);
    return chambers;
}

}  // namespace recoat
