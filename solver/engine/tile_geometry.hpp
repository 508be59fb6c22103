#pragma once

#include "solver/engine/partner.hpp"
#include "solver/engine/tile_work.hpp"
#include "solver/execution/simd.hpp"

namespace recoat {

/// Types of the loops of one variant with one instruction set.
template <class Set, class Variant>
struct TileTypes {
    using S = Simd<Set>;
    using Real = typename Variant::Real;
    using Double = typename S::Double;
    using T = std::conditional_t<Variant::single, typename S::Single, Double>;
    using Row = typename S::Row;
    static constexpr int width = Variant::single ? S::singles : S::doubles;
    static constexpr int groups = width / S::doubles;

    static RECOAT_HD T narrowed(const Double* x) {
        if constexpr (Variant::single)
            return S::narrow(x);
        else
            return *x;
    }
};

/// A pack's worth of an array from place k on; where the array ends before, the last entry again.
template <int width, class Number>
RECOAT_HD const Number* whole(const Number* array, std::size_t k, std::size_t end, Number* buffer) {
    if (k + width <= end) return array + k;
    for (std::size_t l = 0; l < width; ++l) buffer[l] = array[k + l < end ? k + l : end - 1];
    return buffer;
}

/// Where and how the partners of a pack of contacts meet, and how they move.
template <class T>
struct TileMeeting {
    Vec3Of<T> normal;  ///< from the first to the second
    T separation, distance;
    T first_radius, second_radius;
    T first_arm, second_arm;
    Vec3Of<T> velocity;  ///< of the first relative to the second
    Vec3Of<T> arm_spin;
    T velocity_change;  ///< see ParticleTile: bound of what both velocities changed by in the last step [m/s]
};

/// Loads pairs.
template <class Set, class Variant>
struct PairTile {
    using Types = TileTypes<Set, Variant>;
    using S = typename Types::S;
    using T = typename Types::T;
    using Double = typename Types::Double;
    using Row = typename Types::Row;
    using Work = TileWork<Variant>;
    static constexpr bool is_wall = false;
    static constexpr int width = Types::width;

    const Work& w;

    RECOAT_HD void operator()(const std::int32_t* i, const std::int32_t* j, TileMeeting<T>& m) const {
        distances(i, j, m);
        const T r = m.first_radius, q = m.second_radius;
        // No choice between packs by `?:`, which would tie them to memory.
        if (w.radius_arm) {
            m.first_arm = r;
            m.second_arm = q;
        } else {
            m.first_arm = T(0.5) * m.distance;
            if constexpr (!Variant::equal) m.first_arm += (r - q) * (r + q) / (T(2) * m.distance);
            m.second_arm = m.distance - m.first_arm;
        }
        motions(i, j, m);
    }
    RECOAT_HD decltype(auto) coefficients(const T& first_radius, const T& second_radius) const {
        return w.sizes.of_pair(first_radius, second_radius);
    }
    /// Rate at which the velocities of the arrays close.
    RECOAT_HD T closing_rate(const double* velocity, const std::int32_t* i, const std::int32_t* j,
                             const Vec3Of<T>& normal) const {
        Double x[Types::groups], y[Types::groups], z[Types::groups];
        for (int g = 0; g < Types::groups; ++g) {
            Row rows[S::doubles];
            for (int l = 0, k = g * S::doubles; l < S::doubles; ++l, ++k)
                rows[l] =
                    S::subtract(S::row(velocity + 4 * std::size_t(j[k])), S::row(velocity + 4 * std::size_t(i[k])));
            Double rest;
            S::packs(rows, x[g], y[g], z[g], rest);
        }
        return dot(Vec3Of<T>{Types::narrowed(x), Types::narrowed(y), Types::narrowed(z)}, normal);
    }
    RECOAT_HD T spin_share(const std::int32_t* i, const std::int32_t* j) const {
        typename Variant::Real share[width];
        for (int l = 0; l < width; ++l) {
            const std::int32_t a = w.contact_count[i[l]], b = w.contact_count[j[l]];
            share[l] = typename Variant::Real(1) / static_cast<typename Variant::Real>(a > b ? a : b);
        }
        return S::load(share);
    }
    RECOAT_HD Vec3Of<T> lagging_spin(const std::int32_t* i, const std::int32_t* j) const {
        return rows_of(w.spin, i, j, [](Row a, Row b) { return S::subtract(a, b); });
    }
    RECOAT_HD T rolling_inertia(const T& r, const T& q) const {
        if constexpr (Variant::equal) {
            return T(typename Variant::Real(0.5 * w.sizes.inertia));
        } else {
            const T a = T(0.4) * w.sizes.mass_of(r) * r * r, b = T(0.4) * w.sizes.mass_of(q) * q * q;
            return a * b / (a + b);
        }
    }

private:
    /// Separations are differences of doubles; what follows from them may be single.
    RECOAT_HD void distances(const std::int32_t* i, const std::int32_t* j, TileMeeting<T>& m) const {
        using Real = typename Variant::Real;
        Double x[Types::groups], y[Types::groups], z[Types::groups], excess[Types::groups], reach[Types::groups];
        for (int g = 0; g < Types::groups; ++g) {
            Row rows[S::doubles];
            for (int l = 0, k = g * S::doubles; l < S::doubles; ++l, ++k)
                rows[l] =
                    S::subtract(S::row(w.position + 4 * std::size_t(j[k])), S::row(w.position + 4 * std::size_t(i[k])));
            Double rest;
            S::packs(rows, x[g], y[g], z[g], rest);
            y[g] = y[g] - Double(w.y_period) * rounded(y[g] * Double(w.inverse_period));
            if constexpr (Variant::equal)
                reach[g] = Double(2 * w.sizes.radius);
            else
                reach[g] = Double(2) * first_radii(i + g * S::doubles) + rest;
            if constexpr (Variant::single) excess[g] = x[g] * x[g] + y[g] * y[g] + z[g] * z[g] - reach[g] * reach[g];
        }
        const Vec3Of<T> d = {Types::narrowed(x), Types::narrowed(y), Types::narrowed(z)};
        const T square = squared_norm(d), inverse = inverse_root(larger(square, T(Real(1e-36))));
        m.distance = square * inverse;
        m.normal = inverse * d;
        const T both = Types::narrowed(reach);
        if constexpr (Variant::single)
            m.separation = Types::narrowed(excess) / (m.distance + both);
        else
            m.separation = m.distance - both;
        if constexpr (Variant::equal) {
            m.first_radius = m.second_radius = T(Real(w.sizes.radius));
        } else {
            Double r[Types::groups];
            for (int g = 0; g < Types::groups; ++g) r[g] = first_radii(i + g * S::doubles);
            m.first_radius = Types::narrowed(r);
            m.second_radius = both - m.first_radius;
        }
    }

    RECOAT_HD void motions(const std::int32_t* i, const std::int32_t* j, TileMeeting<T>& m) const {
        if constexpr (Variant::single && Variant::equal) {
            typename S::Motion rows[width];
            for (int l = 0; l < width; ++l)
                rows[l] = S::relative(S::motion(w.motion + 8 * std::size_t(i[l])),
                                      S::motion(w.motion + 8 * std::size_t(j[l])));
            T p[8];
            S::packs(rows, p);
            m.velocity = {p[0], p[1], p[2]};
            m.arm_spin = m.first_arm * Vec3Of<T>{p[4], p[5], p[6]};
            m.velocity_change = p[7];
        } else if constexpr (Variant::single) {
            typename S::Motion a[width], b[width];
            for (int l = 0; l < width; ++l) {
                a[l] = S::motion(w.motion + 8 * std::size_t(i[l]));
                b[l] = S::motion(w.motion + 8 * std::size_t(j[l]));
            }
            T p[8], q[8];
            S::packs(a, p);
            S::packs(b, q);
            m.velocity = {p[0] - q[0], p[1] - q[1], p[2] - q[2]};
            m.arm_spin = m.first_arm * Vec3Of<T>{p[4], p[5], p[6]} + m.second_arm * Vec3Of<T>{q[4], q[5], q[6]};
            m.velocity_change = p[7] + q[7];
        } else {
            T unused;
            m.velocity = rows_of(
                w.contact_velocity, i, j, [](Row a, Row b) { return S::subtract(a, b); }, unused);
            if constexpr (Variant::equal) {
                m.arm_spin = m.first_arm *
                             rows_of(
                                 w.contact_spin, i, j, [](Row a, Row b) { return S::add(a, b); }, m.velocity_change);
            } else {
                T change;
                m.arm_spin = m.first_arm * rows_of(
                                               w.contact_spin, i, j, [](Row a, Row) { return a; }, change) +
                             m.second_arm * rows_of(
                                                w.contact_spin, i, j, [](Row, Row b) { return b; }, m.velocity_change);
                m.velocity_change += change;
            }
        }
    }

    template <class Combine>
    RECOAT_HD Vec3Of<T> rows_of(const double* rows, const std::int32_t* i, const std::int32_t* j,
                                const Combine& combine) const {
        T unused;
        return rows_of(rows, i, j, combine, unused);
    }
    template <class Combine>
    RECOAT_HD Vec3Of<T> rows_of(const double* rows, const std::int32_t* i, const std::int32_t* j,
                                const Combine& combine, T& fourth) const {
        Double p[4][Types::groups];
        for (int g = 0; g < Types::groups; ++g) {
            Row r[S::doubles];
            for (int l = 0, k = g * S::doubles; l < S::doubles; ++l, ++k)
                r[l] = combine(S::row(rows + 4 * std::size_t(i[k])), S::row(rows + 4 * std::size_t(j[k])));
            S::packs(r, p[0][g], p[1][g], p[2][g], p[3][g]);
        }
        fourth = Types::narrowed(p[3]);
        return {Types::narrowed(p[0]), Types::narrowed(p[1]), Types::narrowed(p[2])};
    }

    RECOAT_HD Double first_radii(const std::int32_t* i) const {
        double r[S::doubles];
        for (int l = 0; l < S::doubles; ++l) r[l] = w.position[4 * std::size_t(i[l]) + 3];
        return S::load(r);
    }

    static RECOAT_HD Double rounded(Double x) {
        using std::rint;
        return rint(x);
    }
};

}  // namespace recoat
