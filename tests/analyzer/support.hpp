#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <initializer_list>
#include <random>
#include <vector>

#include "analyzer/configuration.hpp"
#include "analyzer/fields/layer.hpp"

namespace recoat::testing {

/// One particle, lengths in d_p.
struct Ball {
    double x, y, z = 0.5, radius = 0.5;
};

/// A configuration in which lengths in metres are lengths in d_p: region [0, length), period [0, width), h_b = 1.5.
inline AnalysisConfig unit_config(double length, double width) {
    AnalysisConfig config;
    config.particle_diameter = 1;
    config.density = 1;
    config.clearance = 1.5;
    config.x_end = length;
    config.y_period = width;
    return config;
}

/// Side of the parts as near to a nominal side as fit into a length a whole number of times: the definition.
inline double fitted(double length, double nominal) { return length / std::max(1.0, std::round(length / nominal)); }

inline Layer layer_of(const std::vector<Ball>& balls, const AnalysisConfig& config) {
    Source source;
    for (const Ball& ball : balls) {
        source.position.push_back({ball.x, ball.y, ball.z});
        source.radius.push_back(ball.radius);
    }
    return make_layer(source, config);
}

/// Random overlapping spheres of radius 0.2 to 0.7 in and around the region; some above h_b, some through the base.
inline std::vector<Ball> random_balls(std::size_t count, double length, double width, std::uint64_t seed) {
    std::mt19937_64 generator(seed);
    const auto between = [&](double low, double high) {
        return low + (high - low) * static_cast<double>(generator()) / 0x1p64;
    };
    std::vector<Ball> balls;
    for (std::size_t i = 0; i < count; ++i) {
        balls.push_back({between(-2, length + 2), between(-width, 2 * width), between(0.1, 2.2), between(0.2, 0.7)});
    }
    return balls;
}

}  // namespace recoat::testing
