#pragma once

#include "solver/engine/tile_geometry.hpp"
#include "solver/engine/tile_scatter.hpp"

namespace recoat {

/// Solves the attraction of the near contacts of one kind of partner and adds up its impulses: first each contact by
/// itself, then once more with what the impulses found so far do to both partners [docs/physics.md section 2.5].
template <class Set, class Variant, class Partner>
struct NearTile {
    using Types = TileTypes<Set, Variant>;
    using S = typename Types::S;
    using T = typename Types::T;
    using Real = typename Variant::Real;
    using Row = typename Types::Row;
    using Work = TileWork<Variant>;
    using Sum = SumLayout<Variant>;
    static constexpr int width = Types::width;

    const Work& w;
    const Partner& partner;

    template <bool again, class Impulse>
    RECOAT_HD void solve(const Impulse& impulse, TileRange range) const {
        double work = 0;
        for (std::size_t n = range.begin; n < range.end; n += width) work += pack<again>(impulse, n, range.end);
        if constexpr (Partner::is_wall)
            if (range.begin < range.end) w.wall_work[std::size_t(w.near.contact[range.begin])] += work;
    }

private:
    template <bool again, class Impulse>
    RECOAT_HD double pack(const Impulse& impulse, std::size_t n, std::size_t end) const {
        const int lanes = n + width <= end ? width : static_cast<int>(end - n);
        std::int32_t i[width], j[width], contact_buffer[width];
        const std::int32_t* contact = whole<width>(w.near.contact, n, end, contact_buffer);
        for (int l = 0; l < width; ++l) {
            i[l] = w.first[contact[l]];
            j[l] = w.second[contact[l]];
        }
        Real buffer[width];
        Vec3Of<T> normal = {S::load(whole<width>(w.near.normal_x, n, end, buffer)), T(Real(0)), T(Real(0))};
        normal.y = S::load(whole<width>(w.near.normal_y, n, end, buffer));
        normal.z = S::load(whole<width>(w.near.normal_z, n, end, buffer));
        const T separation = S::load(whole<width>(w.near.separation, n, end, buffer));
        const T rate = partner.closing_rate(again ? w.contact_velocity : w.velocity, i, j, normal);
        const auto& c = coefficients(i, j);
        const T before = again ? forces_before(contact) : T(Real(0));
        const T force = impulse(separation, rate_without(before, rate, c, w.time_step), c);
        const T push = T(Real(w.time_step)) * (force - before);
        const Vec3Of<T> change = push * normal;
        Row rows[width];
        S::rows(change.x, change.y, change.z, T(Real(0)), rows);
        Real forces[width];
        S::store(forces, force);
        const TileScatter<Set, Variant> to{w.sums};
        const Row opposite = S::row_of(-1, -1, -1, 1);
        for (int l = 0; l < lanes; ++l) {
            w.last_attraction[contact[l]] = forces[l];
            to.add(to.at(i[l]) + Sum::attraction, rows[l]);
            if constexpr (!Partner::is_wall)
                to.add(to.at(w.second_sums[contact[l]]) + Sum::attraction, rows[l], opposite);
        }
        if constexpr (Partner::is_wall) {
            Real power[width];
            S::store(power, partner.wall_power(change));
            double work = 0;
            for (int l = 0; l < lanes; ++l) work += static_cast<double>(power[l]);
            return work;
        }
        return 0;
    }

    RECOAT_HD T forces_before(const std::int32_t* contact) const {
        Real force[width];
        for (int l = 0; l < width; ++l) force[l] = w.last_attraction[contact[l]];
        return S::load(force);
    }

    RECOAT_HD auto coefficients(const std::int32_t* i, const std::int32_t* j) const {
        Real a[width], b[width];
        for (int l = 0; l < width; ++l) {
            a[l] = b[l] = static_cast<Real>(w.position[4 * std::size_t(i[l]) + 3]);
            if constexpr (!Partner::is_wall) b[l] = static_cast<Real>(w.position[4 * std::size_t(j[l]) + 3]);
        }
        return partner.coefficients(S::load(a), S::load(b));
    }
};

}  // namespace recoat
