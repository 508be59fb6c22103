#pragma once

#include <string>
#include <vector>

#include "solver/scene/scene.hpp"

namespace recoat {

/// What can be run but is probably not meant, one sentence each: spheres as soft as jelly, a blade that nothing passes
/// under or that passes above the powder, a rest that is none, materials in another unit, sizes far from d_p.
std::vector<std::string> scene_notes(const Scene& scene);

/// The largest overlap to expect of two smallest spheres [radii]: of an impact at the reference speed, of the
/// attraction at rest, and of the weight of the powder above.
double expected_overlap(const Scene& scene);

}  // namespace recoat
