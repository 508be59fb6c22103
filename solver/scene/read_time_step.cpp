#include "solver/scene/read_time_step.hpp"

#include "common/number.hpp"
#include "solver/scene/automatic_time_step.hpp"

namespace recoat {

void read_time_step(const Config& config, Scene& scene) {
    constexpr std::string_view key = "time_step";
    if (!config.has(key) || config.is_word(key, "auto"))
        scene.time_step_choice = TimeStepChoice::automatic;
    else if (config.is_word(key, "fast"))
        scene.time_step_choice = TimeStepChoice::fast;
    if (scene.time_step_choice != TimeStepChoice::given)
        config.settle(key, shortest(chosen_time_step(scene, scene.time_step_choice)) + " s");
    scene.time_step = config.quantity(key, Dimension::time, Range::positive());
}

}  // namespace recoat
