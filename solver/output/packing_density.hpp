#pragma once

#include "solver/engine/engine.hpp"

namespace recoat {

/// Global packing density of a bed of base area `area` [m2] [paper eq. 14]: volume of the spheres whose centres are
/// below 0.9 z_max, over area (0.9 z_max - z_min), with z_max = max(z + r) and z_min = min(z - r). 0 without particles.
double bed_packing_density(const ParticleTable& particles, double area);

}  // namespace recoat
