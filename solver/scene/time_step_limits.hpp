#pragma once

#include <string>
#include <vector>

#include "solver/scene/scene.hpp"

namespace recoat {

/// A length of the time step that something imposes.
struct StepLimit {
    std::string name, formula;
    double limit = 0;        ///< [s]
    bool stability = false;  ///< a longer step diverges; otherwise it costs accuracy
};

/// Largest overlap of two of the smallest spheres that meet at relative speed `speed` without damping [m]; of the
/// reduced stiffness [docs/physics.md section 4.1].
double largest_impact_overlap(const Scene& scene, double speed);

/// Duration of that impact [s].
double contact_time(const Scene& scene, double speed);

/// sqrt(2 m* s_min/F_o) [s]: the smallest spheres cross s_min in it under their largest attraction F_o; the impulse of
/// a longer step needs more than a fixed point [docs/physics.md section 2.5].
double attraction_crossing_time(const Scene& scene);

/// Every limit for the smallest spheres of the scene with the reduced stiffness [docs/physics.md sections 2.5 and 4.1]:
/// frequencies grow as 1/R or faster as spheres get smaller.
std::vector<StepLimit> time_step_limits(const Scene& scene);

}  // namespace recoat
