#pragma once

#include "solver/engine/tile_geometry.hpp"
#include "solver/engine/tile_scatter.hpp"
#include "solver/engine/tile_stage.hpp"

namespace recoat {

/// Contact forces of a stretch of contacts that have one kind of partner.
template <class Set, class Variant, class Partner>
struct ContactTile {
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

    RECOAT_HD void operator()(TileRange range, std::size_t near_begin, TileTally& tally) const {
        if (range.begin == range.end) return;
        Booked booked{T(Real(0)), T(Real(0)), T(Real(0)), T(Real(-1))};
        std::size_t near = near_begin;
        for (std::size_t k = range.begin; k < range.end; k += packs * width) block(k, range.end, near, booked);
        tally.near = near - near_begin;
        const double overlap = S::highest(booked.overlap);
        tally.largest_overlap = tally.largest_overlap < overlap ? overlap : tally.largest_overlap;
        w.lost_normal[range.begin] += w.time_step * S::sum(booked.normal);
        w.lost_tangential[range.begin] += w.time_step * S::sum(booked.tangential);
        if constexpr (Partner::is_wall) w.wall_work[range.begin] += w.time_step * S::sum(booked.wall);
    }

private:
    using Stage = TileStage<T>;

    /// Packs that go through one part of the law after the other: as many as stay in the first cache.
    static constexpr int packs = static_cast<int>(512 / sizeof(T));

    struct Booked {
        T normal, tangential, wall, overlap;
    };

    /// Indices of the packs of a block; behind the end the last contact again.
    struct Places {
        std::int32_t buffer[2][width];
        const std::int32_t *first, *second;

        RECOAT_HD Places(const Work& w, std::size_t k, std::size_t end)
            : first(whole<width>(w.first, k, end, buffer[0])), second(whole<width>(w.second, k, end, buffer[1])) {}
    };

    RECOAT_HD void block(std::size_t begin, std::size_t end, std::size_t& near, Booked& booked) const {
        Stage stage[packs];
        const std::size_t left = (end - begin + width - 1) / width;
        const int count = left < packs ? static_cast<int>(left) : packs;
        for (int p = 0; p < count; ++p) approach(stage[p], begin + std::size_t(p * width), end);
        for (int p = 0; p < count; ++p) push(stage[p], begin + std::size_t(p * width), end, booked);
        for (int p = 0; p < count; ++p) pull(stage[p]);
        for (int p = 0; p < count; ++p) finish(stage[p], begin + std::size_t(p * width), end, near, booked);
    }

    RECOAT_HD void approach(Stage& stage, std::size_t k, std::size_t end) const {
        const Places at(w, k, end);
        TileMeeting<T> m;
        partner(at.first, at.second, m);
        const KinematicsOf<T> motion = kinematics(m.normal, m.separation, m.velocity, m.arm_spin);
        Stage::set(stage.normal, m.normal);
        Stage::set(stage.sliding_velocity, motion.sliding_velocity);
        stage.separation = m.separation;
        stage.closing_rate = motion.closing_rate;
        stage.first_arm = m.first_arm;
        if constexpr (Variant::cohesive) stage.velocity_change = m.velocity_change;
        if constexpr (!Variant::equal) {
            stage.second_arm = m.second_arm;
            stage.first_radius = m.first_radius;
            stage.second_radius = m.second_radius;
        }
    }

    RECOAT_HD decltype(auto) coefficients(const Stage& stage) const {
        return partner.coefficients(stage.first_radius, stage.second_radius);
    }

    /// Along the normal, and the displacement at this instant: two chains of roots side by side.
    RECOAT_HD void push(Stage& stage, std::size_t k, std::size_t end, Booked& booked) const {
        Real buffer[width];
        T before = T(Real(0));
        if constexpr (Variant::cohesive) before = S::load(whole<width>(w.last_attraction, k, end, buffer));
        const auto push = w.law.push(stage.separation, stage.closing_rate, before, coefficients(stage));
        Vec3Of<T> slip;
        slip.x = S::load(whole<width>(w.slip_x, k, end, buffer));
        slip.y = S::load(whole<width>(w.slip_y, k, end, buffer));
        slip.z = S::load(whole<width>(w.slip_z, k, end, buffer));
        slip = w.law.slid(slip, Stage::vector(stage.normal), Stage::vector(stage.sliding_velocity), stage.separation,
                          T(Real(w.time_step)));
        booked.normal += k + width <= end ? push.power : first_lanes(static_cast<int>(end - k)) * push.power;
        stage.repulsion = push.repulsion;
        stage.set_load(push.load);
        Stage::set(stage.slip, slip);
    }

    RECOAT_HD void pull(Stage& stage) const {
        Vec3Of<T> slip = Stage::vector(stage.slip);
        const auto pull =
            w.law.pull(slip, stage.friction_load(), Stage::vector(stage.sliding_velocity), coefficients(stage));
        Stage::set(stage.slip, slip);
        Stage::set(stage.pull, pull.sum);
        stage.limit = pull.limit;
    }

    RECOAT_HD void finish(const Stage& stage, std::size_t k, std::size_t end, std::size_t& near, Booked& booked) const {
        const bool full = k + width <= end;
        const int lanes = full ? width : static_cast<int>(end - k);
        const T counts = full ? T(Real(1)) : first_lanes(lanes);
        const Vec3Of<T> normal = Stage::vector(stage.normal), sliding = Stage::vector(stage.sliding_velocity);
        const Vec3Of<T> tangential = w.law.mindlin.borne(Stage::vector(stage.pull), stage.limit);
        const Vec3Of<T> force = w.law.force(tangential, stage.repulsion, normal);
        const Vec3Of<T> after = w.law.slid_after(sliding, stage.separation, T(Real(w.time_step)));
        keep(w.slip_x, k, lanes, stage.slip[0] + after.x);
        keep(w.slip_y, k, lanes, stage.slip[1] + after.y);
        keep(w.slip_z, k, lanes, stage.slip[2] + after.z);
        booked.tangential += counts * w.law.friction_power(tangential, sliding);
        if constexpr (Partner::is_wall) booked.wall += counts * partner.wall_power(force);
        booked.overlap = larger(booked.overlap, -stage.separation);

        T near_here = T(Real(0));
        Rows rows;
        if constexpr (Variant::cohesive) near_here = attract(k, lanes, stage, near, rows.attraction, booked, counts);
        const auto& c = coefficients(stage);
        const T load = c.rolling_length * stage.load;
        S::rows(force.x, force.y, force.z, load, rows.force);
        const Vec3Of<T> turning = stage.first_arm * cross(normal, tangential);
        S::rows(turning.x, turning.y, turning.z, near_here, rows.torque);
        const Places at(w, k, end);
        if constexpr (Variant::relative_rolling) roll(stage, at, load, rows.rolling);
        std::int32_t buffer[width];
        const std::int32_t* second = at.second;
        if constexpr (!Partner::is_wall) second = whole<width>(w.second_sums, k, end, buffer);
        if (full)
            scatter<true>(at.first, second, width, stage, rows);
        else
            scatter<false>(at.first, second, lanes, stage, rows);
    }

    RECOAT_HD void roll(const Stage& stage, const Places& at, const T& load, Row* rows) const {
        const T inertia =
            partner.spin_share(at.first, at.second) * partner.rolling_inertia(stage.first_radius, stage.second_radius);
        const Vec3Of<T> torque =
            w.law.rolling.relative_torque(partner.lagging_spin(at.first, at.second), Stage::vector(stage.normal), load,
                                          inertia, T(Real(w.time_step)));
        S::rows(torque.x, torque.y, torque.z, T(Real(0)), rows);
    }

    /// What a pack of contacts adds to the sums of its partners.
    struct Rows {
        Row force[width], torque[width], attraction[width], rolling[width];
    };

    /// To the sums at the places i and j.
    template <bool full>
    RECOAT_HD void scatter(const std::int32_t* i, const std::int32_t* j, int lanes, const Stage& stage,
                           const Rows& rows) const {
        Real ratio[width];
        if constexpr (!Variant::equal && !Partner::is_wall) S::store(ratio, stage.second_arm / stage.first_arm);
        if constexpr (full) {
            // The rows stay in registers.
            RECOAT_UNROLL_ALL
            for (int l = 0; l < width; ++l) scatter(i[l], j[l], l, ratio, rows);
        } else {
            for (int l = 0; l < lanes; ++l) scatter(i[l], j[l], l, ratio, rows);
        }
    }

    RECOAT_HD void scatter(std::int32_t i, std::int32_t j, int l, const Real* ratio, const Rows& rows) const {
        const TileScatter<Set, Variant> to{w.sums};
        const Row opposite = S::row_of(-1, -1, -1, 1);
        double* a = to.at(i);
        to.add(a, rows.force[l]);
        to.add(a + 4, rows.torque[l]);
        if constexpr (Variant::cohesive) to.add(a + Sum::attraction, rows.attraction[l]);
        if constexpr (Variant::relative_rolling) to.add(a + Sum::rolling, rows.rolling[l]);
        if constexpr (!Partner::is_wall) {
            double* b = to.at(j);
            to.add(b, rows.force[l], opposite);
            if constexpr (Variant::equal) {
                to.add(b + 4, rows.torque[l]);
            } else {
                const double arm = static_cast<double>(ratio[l]);
                to.add(b + 4, rows.torque[l], S::row_of(arm, arm, arm, 1));
            }
            if constexpr (Variant::cohesive) to.add(b + Sum::attraction, rows.attraction[l], opposite);
            if constexpr (Variant::relative_rolling) to.add(b + Sum::rolling, rows.rolling[l], opposite);
        }
    }

    /// Attraction of contacts that cannot leave their overlap within the step is the constant one, so that nothing has
    /// to be solved; the others within its range are listed. Returns 1 for those, else 0.
    RECOAT_HD T attract(std::size_t k, int lanes, const Stage& stage, std::size_t& near, Row* rows, Booked& booked,
                        const T& counts) const {
        using std::abs;
        // How far they may come apart: at their speed, by three times what their velocities changed by in the last
        // step, and where two other pairs of each partner take hold or let go in this step.
        const auto& c = coefficients(stage);
        const T way =
            T(Real(w.time_step)) * (T(Real(1.5)) * abs(stage.closing_rate) + T(Real(3)) * stage.velocity_change) +
            T(Real(0.1) * w.attraction.minimum_separation) +
            T(Real(2)) * path_per_force<T>(c, Real(w.time_step)) * T(c.attraction_gap);
        const bool exact = w.impulse.index() < 3;  // a discrete gradient; the other schemes know no such constant
        const auto held = stage.separation + way < T(Real(exact ? 0 : -1));
        const auto listed = (stage.separation <= T(Real(w.attraction.cut_off)) + way) & !held;
        const T force = select(held, T(coefficients(stage).attraction_contact), T(Real(0)));
        const Vec3Of<T> normal = Stage::vector(stage.normal);
        const T push = T(Real(w.time_step)) * force;
        S::rows(push * normal.x, push * normal.y, push * normal.z, T(Real(0)), rows);
        keep(w.last_attraction, k, lanes, force);
        if constexpr (Partner::is_wall) booked.wall += counts * partner.wall_power(force * normal);
        unsigned bits = S::bits(listed) & ((1u << lanes) - 1);
        if (bits != 0) list(k, bits, stage, near);
        return select(listed, T(Real(1)), T(Real(0)));
    }

    RECOAT_HD void list(std::size_t k, unsigned bits, const Stage& stage, std::size_t& near) const {
        Real x[width], y[width], z[width], s[width];
        S::store(x, stage.normal[0]);
        S::store(y, stage.normal[1]);
        S::store(z, stage.normal[2]);
        S::store(s, stage.separation);
        for (; bits != 0; bits &= bits - 1, ++near) {
            const int l = __builtin_ctz(bits);
            w.near.contact[near] = static_cast<std::int32_t>(k) + l;
            w.near.normal_x[near] = x[l];
            w.near.normal_y[near] = y[l];
            w.near.normal_z[near] = z[l];
            w.near.separation[near] = s[l];
        }
    }

    static RECOAT_HD void keep(Real* array, std::size_t k, int lanes, T value) {
        if (lanes == width) return S::store(array + k, value);
        Real buffer[width];
        S::store(buffer, value);
        for (int l = 0; l < lanes; ++l) array[k + std::size_t(l)] = buffer[l];
    }
    static RECOAT_HD T first_lanes(int lanes) {
        Real buffer[width];
        for (int l = 0; l < width; ++l) buffer[l] = l < lanes ? 1 : 0;
        return S::load(buffer);
    }
};

}  // namespace recoat
