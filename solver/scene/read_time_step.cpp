#include "solver/scene/read_time_step.hpp"

#include "common/number.hpp"
#include "solver/scene/automatic_time_step.hpp"

namespace recoat {

void read_time_step(const Config& config, Scene& scene) {
    constexpr std::string_view key = "time_step";
    scene.time_step_is_automatic = !config.has(key) || config.is_word(key, "auto");
    if (scene.time_step_is_automatic) config.settle(key, shortest(automatic_time_step(scene)) + " s");
    scene.time_step = config.quantity(key, Dimension::time, Range::positive());
}

}  // namespace recoat
