#include "solver/scene/automatic_time_step.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "common/number.hpp"
#include "solver/scene/time_step_limits.hpp"

namespace recoat {
namespace {

/// A step in shares of the contact time and of the time in which the attraction crosses s_min.
struct StepRule {
    double contact, crossing;
};

// From bench/results/accuracy.json, which `make bench-accuracy` measures.
constexpr StepRule automatic_rule = {0.0225, 0.5};
constexpr StepRule fast_rule = {0.045, 0.8};

double two_digits_down(double value) {
    const double unit = std::pow(10.0, std::floor(std::log10(value)) - 1);
    // By way of its text: the nearest double to two digits, so that the configuration shows two.
    return *parse_number(fmt::format("{:.1e}", std::floor(value / unit * (1 + 1e-12)) * unit));
}

}  // namespace

double chosen_time_step(const Scene& scene, TimeStepChoice choice) {
    const StepRule rule = choice == TimeStepChoice::fast ? fast_rule : automatic_rule;
    double step = rule.contact * contact_time(scene, scene.reference_speed);
    if (scene.model.hamaker > 0) step = std::min(step, rule.crossing * attraction_crossing_time(scene));
    return two_digits_down(step);
}

}  // namespace recoat
