#pragma once

#include <vector>

#include "solver/engine/engine.hpp"

namespace recoat {

/// Number of neighbours of each particle whose centre is closer than 1.005 times the sum of the radii, the paper's
/// criterion of contact [paper section 5.1]; `y_period` 0 means not periodic.
std::vector<double> coordination_numbers(const ParticleTable& particles, double y_period);

}  // namespace recoat
