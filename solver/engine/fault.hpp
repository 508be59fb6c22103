#pragma once

#include "common/error.hpp"
#include "solver/engine/engine.hpp"
#include "solver/engine/snapshot.hpp"

namespace recoat {

/// Sentences for what stops a run [SimulationFault].
SimulationFault overlap_fault(const Snapshot& snapshot, const EngineSetup& setup, std::int64_t first,
                              std::int64_t second, double overlap);
SimulationFault speed_fault(const Snapshot& snapshot, const EngineSetup& setup, std::int64_t particle, double limit);

/// Whether a centre may be where it is.
struct DomainCheck {
    Vec3 lower, upper;
    bool periodic;

    explicit DomainCheck(const EngineSetup& setup)
        : lower(setup.domain_lower), upper(setup.domain_upper), periodic(setup.y_period > 0) {}

    RECOAT_HD bool inside(Vec3 x) const {
        const bool across = periodic ? std::isfinite(x.y) : (x.y >= lower.y && x.y <= upper.y);
        return across && x.x >= lower.x && x.x <= upper.x && x.z >= lower.z && x.z <= upper.z;
    }
};

/// Throws SimulationFault when a centre is outside the domain or not a number.
void require_inside(const Particles& particles, const EngineSetup& setup, std::int64_t step);

}  // namespace recoat
