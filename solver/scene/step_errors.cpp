#include "solver/scene/step_errors.hpp"

#include <array>

#include "solver/scene/time_step_limits.hpp"

namespace recoat {
namespace {

struct Row {
    double contact, crossing;  ///< the step over the contact time, and over the time in which s_min is crossed
    StepErrors errors;
};

// The worst of Bo 5, 50 and 400 in bench/results/accuracy.json, at a ratio of 0.001; rounded up.
constexpr std::array rows = {
    Row{0.0045, 0.1, {0.001, 0.002, 0.0005}},
    Row{0.0113, 0.25, {0.002, 0.005, 0.0025}},
    Row{0.0225, 0.5, {0.004, 0.013, 0.0042}},
    Row{0.045, 0.8, {0.009, 0.025, 0.0065}},
};

}  // namespace

std::optional<StepErrors> step_errors(const Scene& scene) {
    const double contact = scene.time_step / contact_time(scene, scene.reference_speed);
    const double crossing = scene.model.hamaker > 0 ? scene.time_step / attraction_crossing_time(scene) : 0;
    for (const Row& row : rows)
        if (contact <= row.contact && crossing <= row.crossing) return row.errors;
    return std::nullopt;
}

}  // namespace recoat
