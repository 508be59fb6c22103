#pragma once

#include "solver/scene/engine_factory.hpp"
#include "solver/scene/scene.hpp"

namespace recoat {

/// What the engine needs on this machine, measured.
struct Calibration {
    std::size_t particles = 0;             ///< in the measured block
    double particle_steps_per_second = 0;  ///< the best of several short measurements; 0 where none can be made
    double processor_share = 1;            ///< of the clock's time, that the calculating thread had a processor
    double bytes_per_particle = 0;         ///< in memory
    double checkpoint_bytes_per_particle = 0;

    /// Whether other programs took much of the processors' time meanwhile.
    [[nodiscard]] bool busy() const { return processor_share < 0.9; }
};

/// Runs the engine for about half a second on a block of touching spheres of the scene's material and size (simple
/// cubic, three contacts per particle as in a settled bed), on `resources`. The rate is 0 where the block flies apart.
Calibration calibrate(const Scene& scene, std::int64_t particles, const Resources& resources,
                      const EngineFactory& factory);

}  // namespace recoat
