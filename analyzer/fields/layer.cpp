#include "analyzer/fields/layer.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "common/error.hpp"

namespace recoat {
namespace {

/// Wraps into [0, period); the sum of a tiny negative number and the period may round to the period itself.
double wrap(double value, double period) {
    const double wrapped = value - period * std::floor(value / period);
    return wrapped < period ? wrapped : 0.0;
}

/// Farthest centre from the region and largest radius [d_p]: beyond, lengths have been mistaken (m for um).
constexpr double farthest = 1e6, largest = 1e3;

void check_scale(Vec3 position, double radius, std::size_t index) {
    const double distance = std::max({std::abs(position.x), std::abs(position.y), std::abs(position.z)});
    if (distance <= farthest && radius <= largest) return;
    throw InputError(
        fmt::format("particle {} lies {:.3g} particle diameters away and has a radius of {:.3g}; lengths are read "
                    "in metres, check the unit of the file and d_p of the configuration",
                    index, distance, radius));
}

}  // namespace

Layer make_layer(const Source& source, const AnalysisConfig& config) {
    const double d = config.particle_diameter;
    Layer layer;
    layer.length = (config.x_end - config.x_begin) / d;
    layer.width = config.y_period / d;
    layer.clearance = config.clearance / d;
    layer.grid = Grid::over(layer.length, layer.width, config.grid);
    for (std::size_t i = 0; i < source.position.size(); ++i) {
        const Vec3 p = source.position[i];
        const double x = (p.x - config.x_begin) / d;
        const bool inside = x >= -config.bin_tol && x < layer.length - config.bin_tol;
        if (config.crop_first && !inside) continue;
        const Vec3 scaled = {x, (p.y - config.y_min) / d, p.z / d};
        check_scale(scaled, source.radius[i] / d, i);
        layer.x.push_back(x);
        layer.y.push_back(wrap(scaled.y, layer.width));
        layer.z.push_back(scaled.z);
        layer.radius.push_back(source.radius[i] / d);
        layer.in_region.push_back(inside);
        layer.file_index.push_back(i);
    }
    return layer;
}

}  // namespace recoat
