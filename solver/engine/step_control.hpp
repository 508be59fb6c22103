#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>

#include "common/host_device.hpp"

namespace recoat {

/// Why the steps stopped.
enum class Halt : std::int32_t {
    none,
    target,  ///< all steps wanted are done
    stale,   ///< the close list has to be made anew
    deep,    ///< an overlap beyond the limit: the step was not made
    fast     ///< a speed beyond the limit: likewise
};

/// The parts of a step whose largest values decide whether it goes on.
enum class StepStage : std::int32_t { contacts, forces, attraction };

/// What decides about the next step. It lies where the loops run, so that many steps need no look from the host.
struct StepControl {
    std::int64_t step = 0, target = 0;
    std::size_t awake = 0;       ///< particles that move: the first ones
    double margin = 0;           ///< the close list holds until particles have come closer by this [m]
    double travelled = 0;        ///< half of a bound of how much any two have come closer since it was made [m]
    double last_travel = 0;      ///< bound of any particle's or wall's way in the last step [m]
    double largest_overlap = 0;  ///< since the start [m]
    double wall_speed = 0;       ///< of the fastest wall [m/s]
    double peak[3] = {};         ///< of this step: overlap [m], squared speed after forces, after attraction [m2/s2]
    Halt halt = Halt::none;

    /// Before the step: is the list good for it?
    RECOAT_HD bool stale() const { return 2 * (travelled + 2 * last_travel) > margin; }
};

/// Whether a stage may run: no stage before it has found a fault.
struct StepGate {
    const StepControl* control;
    double overlap_limit;  ///< [m]
    StepStage stage;

    RECOAT_HD bool open() const {
        if (control->halt != Halt::none) return false;
        if (stage == StepStage::contacts) return true;
        if (control->peak[0] > overlap_limit) return false;
        return stage == StepStage::forces || std::isfinite(control->peak[1]);
    }
};

/// Ends a step once all its loops are done.
struct StepEnd {
    StepControl* control;
    double time_step, overlap_limit;
    bool cohesive;

    RECOAT_HD bool running() const { return control->halt == Halt::none; }

    RECOAT_HD void operator()() const {
        StepControl& c = *control;
        // Other threads of a device raised the peaks: they have to be read from memory.
        volatile double* peak = c.peak;
        const double overlap = peak[0], forces = peak[1], square = cohesive ? peak[2] : peak[1];
        for (int stage = 0; stage < 3; ++stage) peak[stage] = 0;
        c.largest_overlap = overlap > c.largest_overlap ? overlap : c.largest_overlap;
        if (overlap > overlap_limit) {
            c.halt = Halt::deep;
            return;
        }
        if (!std::isfinite(forces) || !std::isfinite(square)) {
            c.halt = Halt::fast;
            return;
        }
        ++c.step;
        const double speed = std::sqrt(square);
        c.last_travel = (speed > c.wall_speed ? speed : c.wall_speed) * time_step;
        c.travelled += c.last_travel;
        if (c.step == c.target)
            c.halt = Halt::target;
        else if (c.stale())
            c.halt = Halt::stale;
    }
};

}  // namespace recoat
