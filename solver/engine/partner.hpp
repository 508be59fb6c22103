#pragma once

#include <cmath>
#include <cstddef>

#include "solver/contact/coefficients.hpp"
#include "solver/engine/particles.hpp"
#include "solver/engine/wall.hpp"

namespace recoat {

/// Period in y; a period of 0 means none.
struct Period {
    double length = 0, inverse = 0;

    explicit Period(double period) : length(period), inverse(period > 0 ? 1 / period : 0) {}

    /// The nearest image of a difference vector.
    RECOAT_HD Vec3 nearest(Vec3 d) const { return {d.x, d.y - length * std::rint(d.y * inverse), d.z}; }
};

/// Where and how two partners meet.
struct Meeting {
    Vec3 normal;        ///< from the first to the second
    double separation;  ///< [m]
    double distance;    ///< from the first's centre to the second's centre, or to the wall's closest point [m]
};

/// The second partner is a particle.
template <class Sizes>
struct ParticlePartner {
    static constexpr bool is_wall = false, equal = Sizes::equal;
    Sizes sizes;
    Period period;
    double radius_arm;  ///< 1: arms are radii, 0: to the contact point (a number, so that loops stay vectors)

    RECOAT_HD Meeting meet(const ParticleView& p, std::int32_t i, std::int32_t j) const {
        const Vec3 d = period.nearest(load(p.position, j).xyz() - load(p.position, i).xyz());
        const double distance = std::sqrt(squared_norm(d));
        const double reach = sizes.radius_of(p.position[i].w) + sizes.radius_of(p.position[j].w);
        return {(1 / (distance > 1e-300 ? distance : 1e-300)) * d, distance - reach, distance};
    }
    RECOAT_HD decltype(auto) coefficients(const ParticleView& p, std::int32_t i, std::int32_t j) const {
        return sizes.of_pair(p.position[i].w, p.position[j].w);
    }
    /// Arm of the first: to the plane of the common circle of both spheres [docs/physics.md section 1.2].
    RECOAT_HD double first_arm(const ParticleView& p, std::int32_t i, std::int32_t j, double d) const {
        const double r = sizes.radius_of(p.position[i].w), q = sizes.radius_of(p.position[j].w);
        const double common = Sizes::equal ? 0.5 * d : (d * d + (r - q) * (r + q)) / (2 * d);
        return radius_arm > 0 ? r : common;
    }
    RECOAT_HD double second_arm(const ParticleView& p, std::int32_t j, double d, double first) const {
        return radius_arm > 0 ? sizes.radius_of(p.position[j].w) : d - first;
    }
    RECOAT_HD Vec3 velocity(const Row* v, std::int32_t j) const { return load(v, j).xyz(); }
    RECOAT_HD Vec3 spin(const ParticleView& p, std::int32_t j) const { return load(p.contact_spin, j).xyz(); }
    RECOAT_HD Vec3 lagging_spin(const ParticleView& p, std::int32_t j) const { return load(p.spin, j).xyz(); }
    /// Number of listed contacts of the partner that has more.
    RECOAT_HD std::int32_t busiest(const std::int32_t* incidence_begin, std::int32_t i, std::int32_t j) const {
        const std::int32_t first = incidence_begin[i + 1] - incidence_begin[i];
        const std::int32_t second = incidence_begin[j + 1] - incidence_begin[j];
        return first > second ? first : second;
    }
    RECOAT_HD double rolling_inertia(const ParticleView& p, std::int32_t i, std::int32_t j) const {
        const double a = sizes.inertia_of(p.position[i].w), b = sizes.inertia_of(p.position[j].w);
        return a * b / (a + b);
    }
};

/// A plane, met along its normal.
struct PlaneShape {
    Vec3 point, normal;

    explicit PlaneShape(const Wall& wall) : point(wall.point), normal(wall.normal) {}
    RECOAT_HD PlaneShape(const WallAnchor& from, Vec3 way) : point(from.point + way), normal(from.normal) {}

    RECOAT_HD Meeting meet(Vec3 centre, double radius) const {
        const double height = dot(centre - point, normal);
        return {-normal, height - radius, height};
    }
};

/// A box, met at its closest point: face, edge or corner.
struct BoxShape {
    Vec3 lower, upper;

    explicit BoxShape(const Wall& wall) : lower(wall.lower), upper(wall.upper) {}
    RECOAT_HD BoxShape(const WallAnchor& from, Vec3 way) : lower(from.lower + way), upper(from.upper + way) {}

    RECOAT_HD Meeting meet(Vec3 c, double radius) const {
        const Vec3 closest = {clamp(c.x, lower.x, upper.x), clamp(c.y, lower.y, upper.y), clamp(c.z, lower.z, upper.z)};
        const Vec3 d = closest - c;
        const double distance = std::sqrt(squared_norm(d));
        return {(1 / (distance > 1e-300 ? distance : 1e-300)) * d, distance - radius, distance};
    }

private:
    static RECOAT_HD double clamp(double x, double lo, double hi) { return x < lo ? lo : (x > hi ? hi : x); }
};

/// The second partner is a wall: infinite mass and radius, its own velocity.
template <class Sizes, class Shape>
struct WallPartner {
    static constexpr bool is_wall = true, equal = Sizes::equal;
    Sizes sizes;
    Shape shape;
    Vec3 wall_velocity;
    double radius_arm;  ///< 1: arms are radii, 0: to the contact point (a number, so that loops stay vectors)

    /// The same with a wall at its place in `step`.
    RECOAT_HD WallPartner at(const WallAnchor& wall, std::int64_t step, double time_step) const {
        return {sizes, Shape(wall, wall.way(step, time_step)), wall.velocity, radius_arm};
    }

    RECOAT_HD Meeting meet(const ParticleView& p, std::int32_t i, std::int32_t) const {
        return shape.meet(load(p.position, i).xyz(), sizes.radius_of(p.position[i].w));
    }
    RECOAT_HD decltype(auto) coefficients(const ParticleView& p, std::int32_t i, std::int32_t) const {
        return sizes.of_wall(p.position[i].w);
    }
    RECOAT_HD double first_arm(const ParticleView& p, std::int32_t i, std::int32_t, double d) const {
        return radius_arm > 0 ? sizes.radius_of(p.position[i].w) : d;
    }
    RECOAT_HD double second_arm(const ParticleView&, std::int32_t, double, double) const { return 0; }
    RECOAT_HD Vec3 velocity(const Row*, std::int32_t) const { return wall_velocity; }
    RECOAT_HD Vec3 spin(const ParticleView&, std::int32_t) const { return {}; }
    RECOAT_HD Vec3 lagging_spin(const ParticleView&, std::int32_t) const { return {}; }
    RECOAT_HD std::int32_t busiest(const std::int32_t* incidence_begin, std::int32_t i, std::int32_t) const {
        return incidence_begin[i + 1] - incidence_begin[i];
    }
    RECOAT_HD double rolling_inertia(const ParticleView& p, std::int32_t i, std::int32_t) const {
        return sizes.inertia_of(p.position[i].w);
    }
    /// Power of the wall on the particle under `force` on the particle [W].
    RECOAT_HD double wall_power(Vec3 force) const { return dot(force, wall_velocity); }
};

}  // namespace recoat
