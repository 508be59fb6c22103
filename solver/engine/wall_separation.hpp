#pragma once

#include "solver/engine/partner.hpp"

namespace recoat {

/// Distance of a particle's surface from a wall at its place in `step` [m].
RECOAT_HD double wall_separation(const WallAnchor& wall, std::int64_t step, double time_step, const Row& particle) {
    const Vec3 way = wall.way(step, time_step);
    return wall.kind == WallKind::plane ? PlaneShape(wall, way).meet(particle.xyz(), particle.w).separation
                                        : BoxShape(wall, way).meet(particle.xyz(), particle.w).separation;
}

}  // namespace recoat
