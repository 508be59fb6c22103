#pragma once

#include <memory>

#include "solver/engine/snapshot.hpp"
#include "solver/engine/step_control.hpp"

namespace recoat {

/// The step on a processor: contacts and then particles of one tile after the other, while they are in the cache, with
/// explicit vectors [docs/decisions/0010].
class TileStepper {
public:
    TileStepper() = default;
    TileStepper(const TileStepper&) = delete;
    TileStepper& operator=(const TileStepper&) = delete;
    virtual ~TileStepper() = default;

    /// Prepares for steps from `snapshot`, which stays where it is until `end`. Between the two only step() may change
    /// it. `lists` is a number that changes whenever lists, order of the particles or who sleeps do: as long as it is
    /// that of the last time, the snapshot is as `end` left it.
    virtual void begin(Snapshot& snapshot, std::int64_t lists) = 0;
    /// One step; writes the peaks into `control`.
    virtual void step(StepControl& control) = 0;
    /// Brings what has its own place meanwhile back into the snapshot.
    virtual void end() = 0;
};

/// For the sizes and the model of a scene; `radius` is that of all particles, or 0 where they differ.
std::unique_ptr<TileStepper> make_tile_stepper(const EngineSetup& setup, double radius, double smallest_radius);

}  // namespace recoat
