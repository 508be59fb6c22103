#include "analyzer/readers/frame.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include <fmt/format.h>

#include "common/number.hpp"

namespace recoat {
namespace {

double median_diameter(std::vector<double> radius) {
    const auto middle = radius.begin() + static_cast<std::ptrdiff_t>(radius.size() / 2);
    std::ranges::nth_element(radius, middle);
    double median = 2 * *middle;
    if (radius.size() % 2 == 0) median = *middle + *std::max_element(radius.begin(), middle);
    // Six digits: floats carry no more, and lengths in whole diameters shall stay whole.
    return *parse_number(fmt::format("{:.5e}", median));
}

/// Height on which the particles stand.
double find_base(const Source& source, double diameter) {
    double lowest = SourceInfo::unknown;
    for (std::size_t i = 0; i < source.position.size(); ++i) {
        lowest = std::fmin(lowest, source.position[i].z - source.radius[i]);
    }
    if (source.box && std::abs(source.box->lower.z - lowest) <= diameter / 2) return source.box->lower.z;
    return std::abs(lowest) <= diameter / 2 ? 0 : lowest;
}

}  // namespace

void wrap_along_x(Source& source) {
    if (!source.box || !source.box->periodic[0]) return;
    const double low = source.box->lower.x, period = source.box->upper.x - low;
    for (Vec3& p : source.position) {
        if (p.x < low || p.x >= low + period) p.x -= period * std::floor((p.x - low) / period);
    }
}

void complete_frame(Source& source) {
    if (source.position.empty()) return;
    SourceInfo& info = source.info;
    if (std::isnan(info.particle_diameter)) info.particle_diameter = median_diameter(source.radius);
    const auto [x_low, x_high] = std::ranges::minmax(source.position, {}, &Vec3::x);
    info.x_lower = x_low.x;
    info.x_upper = x_high.x;
    const auto [y_low, y_high] = std::ranges::minmax(source.position, {}, &Vec3::y);
    info.y_lower = source.box ? source.box->lower.y : y_low.y;
    info.y_upper = source.box ? source.box->upper.y : y_high.y;
    if (std::isnan(info.y_period) && source.box && source.box->periodic[1]) {
        info.y_min = source.box->lower.y;
        info.y_period = source.box->upper.y - source.box->lower.y;
    }
    if (std::isnan(info.base)) info.base = find_base(source, info.particle_diameter);
}

void lower_to_base(Source& source, double base) {
    for (Vec3& p : source.position) p.z -= base;
    if (!source.box) return;
    source.box->lower.z -= base;
    source.box->upper.z -= base;
}

}  // namespace recoat
