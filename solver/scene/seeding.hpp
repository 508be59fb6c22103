#pragma once

#include "solver/engine/engine.hpp"
#include "solver/scene/scene.hpp"

namespace recoat {

/// Spheres of diameter d_p, or of the column's sizes, at rest at random places of a column on the base, periodic in y:
/// random sequential addition, uniform in the column. No two surfaces, and no surface and wall, are closer than 0.01
/// d_p, so that nothing attracts at the start. Where a sphere finds no place the column grows. The same seed gives the
/// same bits on every machine.
ParticleTable seed_column(const ColumnSource& column, double diameter, double y_period);

}  // namespace recoat
