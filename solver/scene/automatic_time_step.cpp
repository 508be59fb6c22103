#include "solver/scene/automatic_time_step.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "common/number.hpp"
#include "solver/scene/time_step_limits.hpp"

namespace recoat {
namespace {

// Both from bench/results/accuracy.json, which `make bench-accuracy` measures.
constexpr double share_of_contact_time = 0.0225;
constexpr double share_of_crossing_time = 0.24;

double two_digits_down(double value) {
    const double unit = std::pow(10.0, std::floor(std::log10(value)) - 1);
    // By way of its text: the nearest double to two digits, so that the configuration shows two.
    return *parse_number(fmt::format("{:.1e}", std::floor(value / unit * (1 + 1e-12)) * unit));
}

}  // namespace

double automatic_time_step(const Scene& scene) {
    double step = share_of_contact_time * contact_time(scene, scene.reference_speed);
    if (scene.model.hamaker > 0) step = std::min(step, share_of_crossing_time * attraction_crossing_time(scene));
    return two_digits_down(step);
}

}  // namespace recoat
