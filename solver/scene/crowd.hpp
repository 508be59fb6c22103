#pragma once

#include <cstdint>
#include <vector>

#include "common/vec3.hpp"

namespace recoat {

/// Spheres that keep their distance, periodic in y: says whether there is room for one more.
class Crowd {
public:
    /// `lower` and `extent` bound the centres in x and y (z is open upwards), `reach` is the largest sum of two radii
    /// and the gap between surfaces, all [m].
    Crowd(Vec3 lower, Vec3 extent, double reach, double gap);

    /// Adds a sphere unless it is closer than the gap to another.
    bool add(Vec3 centre, double radius);

private:
    struct Sphere {
        Vec3 centre;
        double radius;
    };

    [[nodiscard]] bool has_room(Vec3 centre, double radius, const std::int64_t (&cell)[3]) const;
    [[nodiscard]] bool too_close(const Sphere& sphere, Vec3 centre, double radius) const;
    [[nodiscard]] std::size_t index(std::int64_t x, std::int64_t y, std::int64_t z) const {
        return static_cast<std::size_t>((z * ny_ + y) * nx_ + x);
    }

    Vec3 lower_;
    double period_, gap_, side_x_, side_y_, side_z_;
    std::int64_t nx_, ny_;
    std::vector<std::vector<Sphere>> cells_;
};

}  // namespace recoat
