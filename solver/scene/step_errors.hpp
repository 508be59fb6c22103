#pragma once

#include <optional>

#include "solver/scene/scene.hpp"

namespace recoat {

/// What a time step costs in accuracy, as docs/accuracy.md has measured it; as shares.
struct StepErrors {
    double capture_velocity;  ///< worst phase of the first step
    double rebound;           ///< from the scene's speed, worst phase
    double energy_balance;    ///< of what a bed dissipates while it is filled, or of the work of the blade
};

/// Those of the scene's step: of the shortest one measured that is no shorter in shares of the times of contact and
/// attraction. None where it is longer than all.
std::optional<StepErrors> step_errors(const Scene& scene);

}  // namespace recoat
