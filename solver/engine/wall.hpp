#pragma once

#include <cstdint>
#include <string>

#include "common/vec3.hpp"

namespace recoat {

enum class WallKind : std::int32_t { plane, box };

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

/// Where a wall was when its velocity last changed. Its place now follows from that, so that many small steps do not
/// add up to a rounding error.
struct WallAnchor {
    Vec3 point, normal, lower, upper, velocity;
    std::int64_t since = 0;  ///< step of that moment
    WallKind kind = WallKind::plane;
    bool active = true;

    /// Way from there [m].
    RECOAT_HD Vec3 way(std::int64_t step, double time_step) const {
        return (static_cast<double>(step - since) * time_step) * velocity;
    }
};

}  // namespace recoat
