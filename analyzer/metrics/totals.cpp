#include "analyzer/metrics/totals.hpp"

#include <algorithm>
#include <limits>
#include <numeric>

#include "analyzer/fields/parallel.hpp"
#include "analyzer/fields/sphere_box.hpp"

namespace recoat {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

/// Solid between the x ends of the region and two heights [d_p^3]; added up in the order of the file.
double solid_between(const Layer& layer, double bottom, double top) {
    std::vector<double> volume(layer.size());
    for_each_in_parallel(layer.size(), [&](std::size_t i) {
        volume[i] = sphere_box_volume({layer.x[i], layer.y[i], layer.z[i]}, layer.radius[i], {0, -infinite, bottom},
                                      {layer.length, infinite, top});
    });
    return std::accumulate(volume.begin(), volume.end(), 0.0);
}

/// Whole spheres with their centre in the region and not above `top` [d_p^3].
double whole_below(const Layer& layer, double top) {
    double sum = 0;
    for (std::size_t i = 0; i < layer.size(); ++i) {
        if (layer.in_region[i] && layer.z[i] <= top) sum += sphere_volume(layer.radius[i]);
    }
    return sum;
}

std::optional<TotalsMetrics::BedDensity> bed_density(const Layer& layer, double tolerance) {
    double z_min = infinite, z_max = -infinite;
    for (std::size_t i = 0; i < layer.size(); ++i) {
        if (!layer.in_region[i]) continue;
        z_min = std::min(z_min, layer.z[i] - layer.radius[i]);
        z_max = std::max(z_max, layer.z[i] + layer.radius[i]);
    }
    if (z_max < z_min) return {};
    const double top = 0.9 * z_max, height = top - z_min;
    if (height <= 0) {
        constexpr double undefined = std::numeric_limits<double>::quiet_NaN();
        return TotalsMetrics::BedDensity{undefined, undefined, undefined};
    }
    const double box = layer.length * layer.width * height;
    return TotalsMetrics::BedDensity{.clipped = solid_between(layer, z_min, top) / box,
                                     .centre = whole_below(layer, top + tolerance) / box,
                                     .all = whole_below(layer, infinite) / box};
}

}  // namespace

TotalsMetrics totals_metrics(const Layer& layer, const AnalysisConfig& config) {
    const double d = config.particle_diameter;
    TotalsMetrics totals;
    totals.volume_whole = whole_below(layer, infinite) * d * d * d;
    totals.volume_clipped = solid_between(layer, -infinite, infinite) * d * d * d;
    totals.area = layer.length * layer.width * d * d;
    totals.mass_per_area = config.density * totals.volume_whole / totals.area;
    totals.mass_per_area_clipped = config.density * totals.volume_clipped / totals.area;
    totals.layer_phi = totals.volume_clipped / (totals.area * config.clearance);
    totals.bed = bed_density(layer, config.bin_tol);
    return totals;
}

}  // namespace recoat
