#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "common/vec3.hpp"

namespace recoat::testing {

/// Integral of a smooth function whose derivatives may be singular at the ends, by the double exponential rule.
template <class Function>
double integrate(Function function, double low, double high) {
    constexpr double step = 1.0 / 32, reach = 3.2;
    const double half = 0.5 * (high - low), middle = 0.5 * (high + low);
    double sum = 0;
    for (double t = -reach; t <= reach; t += step) {
        const double u = 0.5 * std::numbers::pi * std::sinh(t), c = std::cosh(u);
        sum += function(middle + half * std::tanh(u)) * 0.5 * std::numbers::pi * std::cosh(t) / (c * c);
    }
    return half * step * sum;
}

/// Area of the unit-centred disc of radius rho in [x0, x1] x [y0, y1], from the antiderivative of its chord.
inline double disc_rectangle_area(double rho, double x0, double x1, double y0, double y1) {
    std::vector<double> breaks = {std::clamp(x0, -rho, rho), std::clamp(x1, -rho, rho)};
    for (const double y : {y0, y1}) {
        if (std::abs(y) >= rho) continue;
        const double x = std::sqrt(rho * rho - y * y);
        for (const double b : {-x, x}) breaks.push_back(std::clamp(b, breaks[0], breaks[1]));
    }
    std::ranges::sort(breaks);
    const auto half_chord_integral = [&](double x) {
        const double inside = std::max(rho * rho - x * x, 0.0);
        return 0.5 * (x * std::sqrt(inside) + rho * rho * std::atan2(x, std::sqrt(inside)));
    };
    double area = 0;
    for (std::size_t i = 0; i + 1 < breaks.size(); ++i) {
        const double low = breaks[i], high = breaks[i + 1], middle = 0.5 * (low + high);
        const double chord = std::sqrt(std::max(rho * rho - middle * middle, 0.0));
        if (std::min(y1, chord) <= std::max(y0, -chord)) continue;
        const double curved = half_chord_integral(high) - half_chord_integral(low);
        area += (y1 < chord ? y1 * (high - low) : curved) - (y0 > -chord ? y0 * (high - low) : -curved);
    }
    return area;
}

/// Volume of a sphere in a box by slices along z, integrated between the heights at which a slice changes its shape:
/// independent of closed forms on the sphere.
inline double sphere_box_by_slices(Vec3 centre, double radius, Vec3 lower, Vec3 upper) {
    const double x[2] = {lower.x - centre.x, upper.x - centre.x}, y[2] = {lower.y - centre.y, upper.y - centre.y};
    const double low = std::clamp(lower.z - centre.z, -radius, radius);
    const double high = std::clamp(upper.z - centre.z, -radius, radius);
    std::vector<double> breaks = {low, high};
    const auto add_break = [&](double squared_distance) {
        const double square = radius * radius - squared_distance;
        if (square <= 0) return;
        for (const double z : {-std::sqrt(square), std::sqrt(square)}) breaks.push_back(std::clamp(z, low, high));
    };
    add_break(0);
    for (const double a : x) add_break(a * a);
    for (const double b : y) add_break(b * b);
    for (const double a : x) {
        for (const double b : y) add_break(a * a + b * b);
    }
    std::ranges::sort(breaks);
    double volume = 0;
    for (std::size_t i = 0; i + 1 < breaks.size(); ++i) {
        volume += integrate(
            [&](double z) {
                return disc_rectangle_area(std::sqrt(std::max(radius * radius - z * z, 0.0)), x[0], x[1], y[0], y[1]);
            },
            breaks[i], breaks[i + 1]);
    }
    return volume;
}

}  // namespace recoat::testing
