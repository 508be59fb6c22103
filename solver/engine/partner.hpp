#pragma once

#include <cmath>
#include <cstddef>

#include "common/select.hpp"
#include "solver/contact/coefficients.hpp"
#include "solver/contact/roots.hpp"
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

/// Where and how two partners, or packs of them, meet.
template <class T>
struct MeetingOf {
    Vec3Of<T> normal;  ///< from the first to the second
    T separation;      ///< [m]
    T distance;        ///< from the first's centre to the second's centre, or to the wall's closest point [m]
};

using Meeting = MeetingOf<double>;

/// Of spheres or points `d` apart, whose radii add up to `reach`. Coinciding centres have no normal.
template <class T>
RECOAT_HD MeetingOf<T> meeting(Vec3Of<T> d, T reach) {
    const T square = squared_norm(d), inverse = inverse_root(larger(square, T(1e-200)));
    const T distance = square * inverse;
    return {inverse * d, distance - reach, distance};
}

/// The same vector in every place of a pack.
template <class T>
RECOAT_HD Vec3Of<T> spread(Vec3 v) {
    return {T(v.x), T(v.y), T(v.z)};
}

/// The second partner is a particle.
template <class Sizes>
struct ParticlePartner {
    static constexpr bool is_wall = false, equal = Sizes::equal;
    Sizes sizes;
    Period period;
    double radius_arm;  ///< 1: arms are radii, 0: to the contact point (a number, so that loops stay vectors)

    RECOAT_HD Meeting meet(const ParticleView& p, std::int32_t i, std::int32_t j) const {
        const Vec3 d = period.nearest(load(p.position, j).xyz() - load(p.position, i).xyz());
        return meeting(d, sizes.radius_of(p.position[i].w) + sizes.radius_of(p.position[j].w));
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

    RECOAT_HD PlaneShape(Vec3 any_point, Vec3 unit_normal) : point(any_point), normal(unit_normal) {}
    explicit PlaneShape(const Wall& wall) : PlaneShape(wall.point, wall.normal) {}
    RECOAT_HD PlaneShape(const WallAnchor& from, Vec3 way) : point(from.point + way), normal(from.normal) {}

    template <class T>
    RECOAT_HD MeetingOf<T> meet(Vec3Of<T> centre, T radius) const {
        const T height = dot(centre - spread<T>(point), spread<T>(normal));
        return {spread<T>(-normal), height - radius, height};
    }
    RECOAT_HD Meeting meet(Vec3 centre, double radius) const { return meet<double>(centre, radius); }
};

/// A box, met at its closest point: face, edge or corner.
struct BoxShape {
    Vec3 lower, upper;

    RECOAT_HD BoxShape(Vec3 lower_corner, Vec3 upper_corner) : lower(lower_corner), upper(upper_corner) {}
    explicit BoxShape(const Wall& wall) : BoxShape(wall.lower, wall.upper) {}
    RECOAT_HD BoxShape(const WallAnchor& from, Vec3 way) : lower(from.lower + way), upper(from.upper + way) {}

    template <class T>
    RECOAT_HD MeetingOf<T> meet(Vec3Of<T> c, T radius) const {
        const Vec3Of<T> closest = {clamped(c.x, T(lower.x), T(upper.x)), clamped(c.y, T(lower.y), T(upper.y)),
                                   clamped(c.z, T(lower.z), T(upper.z))};
        return meeting(closest - c, radius);
    }
    RECOAT_HD Meeting meet(Vec3 centre, double radius) const { return meet<double>(centre, radius); }
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
