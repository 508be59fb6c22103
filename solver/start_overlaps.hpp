#pragma once

#include <string>

#include "solver/engine/engine.hpp"
#include "solver/scene/scene.hpp"

namespace recoat {

/// What an engine that has made no step says about overlaps: how many, the deepest, and the energy in them, which is
/// set free by the first steps. Empty where overlaps are no deeper than contacts of the scene at rest or in an impact.
std::string start_overlaps(const Scene& scene, const Engine& engine);

}  // namespace recoat
