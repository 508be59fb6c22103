#pragma once

#include "solver/engine/tile_geometry.hpp"

namespace recoat {

/// Loads contacts with one wall; as PairTile.
template <class Set, class Variant, class Shape>
struct WallTile {
    using Types = TileTypes<Set, Variant>;
    using S = typename Types::S;
    using T = typename Types::T;
    using Real = typename Variant::Real;
    using Double = typename Types::Double;
    using Row = typename Types::Row;
    using Work = TileWork<Variant>;
    static constexpr bool is_wall = true;
    static constexpr int width = Types::width;

    const Work& w;
    Shape shape;
    Vec3 wall_velocity;

    RECOAT_HD void operator()(const std::int32_t* i, const std::int32_t*, TileMeeting<T>& m) const {
        Double x[Types::groups], y[Types::groups], z[Types::groups];
        Double separation[Types::groups], distance[Types::groups], radius[Types::groups];
        for (int g = 0; g < Types::groups; ++g) {
            Row rows[S::doubles];
            for (int l = 0, k = g * S::doubles; l < S::doubles; ++l, ++k)
                rows[l] = S::row(w.position + 4 * std::size_t(i[k]));
            Vec3Of<Double> centre;
            S::packs(rows, centre.x, centre.y, centre.z, radius[g]);
            if constexpr (Variant::equal) radius[g] = Double(w.sizes.radius);
            const MeetingOf<Double> met = shape.meet(centre, radius[g]);
            x[g] = met.normal.x;
            y[g] = met.normal.y;
            z[g] = met.normal.z;
            separation[g] = met.separation;
            distance[g] = met.distance;
        }
        m.normal = {Types::narrowed(x), Types::narrowed(y), Types::narrowed(z)};
        m.separation = Types::narrowed(separation);
        m.distance = Types::narrowed(distance);
        m.first_radius = m.second_radius = Types::narrowed(radius);
        m.first_arm = m.distance;
        if (w.radius_arm) m.first_arm = m.first_radius;
        m.second_arm = T(Real(0));
        motions(i, m);
    }
    RECOAT_HD decltype(auto) coefficients(const T& radius, const T&) const { return w.sizes.of_wall(radius); }
    RECOAT_HD T closing_rate(const double* velocity, const std::int32_t* i, const std::int32_t*,
                             const Vec3Of<T>& normal) const {
        T unused;
        return dot(spread_wall_velocity() - rows_of(velocity, i, unused), normal);
    }
    RECOAT_HD T spin_share(const std::int32_t* i, const std::int32_t*) const {
        Real share[width];
        for (int l = 0; l < width; ++l) share[l] = Real(1) / static_cast<Real>(w.contact_count[i[l]]);
        return S::load(share);
    }
    RECOAT_HD Vec3Of<T> lagging_spin(const std::int32_t* i, const std::int32_t*) const {
        T unused;
        return rows_of(w.spin, i, unused);
    }
    RECOAT_HD T rolling_inertia(const T& r, const T&) const {
        if constexpr (Variant::equal) {
            return T(Real(w.sizes.inertia));
        } else {
            return T(0.4) * w.sizes.mass_of(r) * r * r;
        }
    }
    /// Power of the wall on the particles under `force` on them [W].
    RECOAT_HD T wall_power(const Vec3Of<T>& force) const { return dot(force, spread_wall_velocity()); }

private:
    RECOAT_HD Vec3Of<T> spread_wall_velocity() const {
        return {T(Real(wall_velocity.x)), T(Real(wall_velocity.y)), T(Real(wall_velocity.z))};
    }

    RECOAT_HD void motions(const std::int32_t* i, TileMeeting<T>& m) const {
        Vec3Of<T> spin;
        if constexpr (Variant::single) {
            typename S::Motion rows[width];
            for (int l = 0; l < width; ++l) rows[l] = S::motion(w.motion + 8 * std::size_t(i[l]));
            T p[8];
            S::packs(rows, p);
            m.velocity = {p[0], p[1], p[2]};
            spin = {p[4], p[5], p[6]};
            m.velocity_change = p[7];
        } else {
            T unused;
            m.velocity = rows_of(w.contact_velocity, i, unused);
            spin = rows_of(w.contact_spin, i, m.velocity_change);
        }
        m.velocity = m.velocity - spread_wall_velocity();
        m.arm_spin = m.first_arm * spin;
    }

    RECOAT_HD Vec3Of<T> rows_of(const double* rows, const std::int32_t* i, T& fourth) const {
        Double p[4][Types::groups];
        for (int g = 0; g < Types::groups; ++g) {
            Row r[S::doubles];
            for (int l = 0, k = g * S::doubles; l < S::doubles; ++l, ++k) r[l] = S::row(rows + 4 * std::size_t(i[k]));
            S::packs(r, p[0][g], p[1][g], p[2][g], p[3][g]);
        }
        fourth = Types::narrowed(p[3]);
        return {Types::narrowed(p[0]), Types::narrowed(p[1]), Types::narrowed(p[2])};
    }
};

}  // namespace recoat
