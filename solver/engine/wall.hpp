#pragma once

#include <string>

#include "common/vec3.hpp"

namespace recoat {

enum class WallKind { plane, box };

/// A rigid wall; particles touch its closest point. It may translate at constant velocity.
struct Wall {
    std::string name;
    WallKind kind = WallKind::plane;
    Vec3 point;         ///< plane: any point of it [m]
    Vec3 normal;        ///< plane: unit vector into the free side
    Vec3 lower, upper;  ///< box: corners; entries may be infinite [m]
    Vec3 velocity;      ///< [m/s]
    bool active = true;

    friend bool operator==(const Wall&, const Wall&) = default;
};

}  // namespace recoat
