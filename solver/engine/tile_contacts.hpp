#pragma once

#include "solver/engine/tile_geometry.hpp"
#include "solver/engine/tile_scatter.hpp"

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
    /// Packs that go through one part of the law after the other: as many as stay in the first cache.
    static constexpr int packs = static_cast<int>(512 / sizeof(T));

    struct Booked {
        T normal, tangential, wall, overlap;
    };

    /// A pack of contacts on its way.
    struct Stage {
        TileMeeting<T> m;
        T closing_rate;
        Vec3Of<T> sliding_velocity, slip;
        typename ContactLaw<Variant::cohesive, Real>::template Push<T> push;
        typename MindlinOf<Real>::template Pull<T> pull;
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
        for (int p = 0; p < count; ++p) push(stage[p], begin + std::size_t(p * width), end);
        for (int p = 0; p < count; ++p) slide(stage[p], begin + std::size_t(p * width), end);
        for (int p = 0; p < count; ++p) pull(stage[p]);
        for (int p = 0; p < count; ++p) finish(stage[p], begin + std::size_t(p * width), end, near, booked);
    }

    RECOAT_HD void approach(Stage& stage, std::size_t k, std::size_t end) const {
        const Places at(w, k, end);
        partner(at.first, at.second, stage.m);
        const KinematicsOf<T> motion =
            kinematics(stage.m.normal, stage.m.separation, stage.m.velocity, stage.m.arm_spin);
        stage.closing_rate = motion.closing_rate;
        stage.sliding_velocity = motion.sliding_velocity;
    }

    RECOAT_HD void push(Stage& stage, std::size_t k, std::size_t end) const {
        Real buffer[width];
        T before = T(Real(0));
        if constexpr (Variant::cohesive) before = S::load(whole<width>(w.last_attraction, k, end, buffer));
        stage.push = w.law.push(stage.m.separation, stage.closing_rate, before, partner.coefficients(stage.m));
    }

    RECOAT_HD void slide(Stage& stage, std::size_t k, std::size_t end) const {
        Real buffer[width];
        Vec3Of<T> slip;
        slip.x = S::load(whole<width>(w.slip_x, k, end, buffer));
        slip.y = S::load(whole<width>(w.slip_y, k, end, buffer));
        slip.z = S::load(whole<width>(w.slip_z, k, end, buffer));
        stage.slip = w.law.slid(slip, stage.m.normal, stage.sliding_velocity, stage.m.separation, T(Real(w.time_step)));
    }

    RECOAT_HD void pull(Stage& stage) const {
        stage.pull = w.law.pull(stage.slip, stage.push.load, stage.sliding_velocity, partner.coefficients(stage.m));
    }

    RECOAT_HD void finish(Stage& stage, std::size_t k, std::size_t end, std::size_t& near, Booked& booked) const {
        const Places at(w, k, end);
        const std::int32_t *i = at.first, *j = at.second;
        const int lanes = k + width <= end ? width : static_cast<int>(end - k);
        const TileMeeting<T>& m = stage.m;
        const auto& c = partner.coefficients(m);
        const T time_step = T(Real(w.time_step));
        const ContactResultOf<T> result =
            w.law.result(stage.push, w.law.mindlin.borne(stage.pull), m.normal, stage.closing_rate, m.separation,
                         stage.sliding_velocity, time_step, stage.slip);
        keep(w.slip_x, k, lanes, stage.slip.x);
        keep(w.slip_y, k, lanes, stage.slip.y);
        keep(w.slip_z, k, lanes, stage.slip.z);
        const T counts = lanes == width ? T(Real(1)) : first_lanes(lanes);
        booked.normal += counts * result.normal_power;
        booked.tangential += counts * result.tangential_power;
        if constexpr (Partner::is_wall) booked.wall += counts * partner.wall_power(result.force);
        booked.overlap = larger(booked.overlap, -m.separation);

        T near_here = T(Real(0));
        Row attraction[width];
        if constexpr (Variant::cohesive)
            near_here = attract(k, lanes, m, stage.closing_rate, c, near, attraction, booked, counts);
        Row force[width], torque[width], rolling[width];
        const T load = c.rolling_length * result.friction_load;
        S::rows(result.force.x, result.force.y, result.force.z, load, force);
        const Vec3Of<T> turning = m.first_arm * cross(m.normal, result.tangential);
        S::rows(turning.x, turning.y, turning.z, near_here, torque);
        if constexpr (Variant::relative_rolling) {
            const T inertia = partner.spin_share(i, j) * partner.rolling_inertia(m);
            const Vec3Of<T> t =
                w.law.rolling.relative_torque(partner.lagging_spin(i, j), m.normal, load, inertia, time_step);
            S::rows(t.x, t.y, t.z, T(Real(0)), rolling);
        }
        std::int32_t buffer[width];
        if constexpr (!Partner::is_wall) j = whole<width>(w.second_sums, k, end, buffer);
        scatter(i, j, lanes, m, force, torque, attraction, rolling);
    }

    /// To the sums at the places i and j.
    RECOAT_HD void scatter(const std::int32_t* i, const std::int32_t* j, int lanes, const TileMeeting<T>& m,
                           const Row* force, const Row* torque, const Row* attraction, const Row* rolling) const {
        const TileScatter<Set, Variant> to{w.sums};
        const Row opposite = S::row_of(-1, -1, -1, 1);
        Real ratio[width];
        if constexpr (!Variant::equal && !Partner::is_wall) S::store(ratio, m.second_arm / m.first_arm);
        for (int l = 0; l < lanes; ++l) {
            double* a = to.at(i[l]);
            to.add(a, force[l]);
            to.add(a + 4, torque[l]);
            if constexpr (Variant::cohesive) to.add(a + Sum::attraction, attraction[l]);
            if constexpr (Variant::relative_rolling) to.add(a + Sum::rolling, rolling[l]);
            if constexpr (!Partner::is_wall) {
                double* b = to.at(j[l]);
                to.add(b, force[l], opposite);
                if constexpr (Variant::equal) {
                    to.add(b + 4, torque[l]);
                } else {
                    const double arm = static_cast<double>(ratio[l]);
                    to.add(b + 4, torque[l], S::row_of(arm, arm, arm, 1));
                }
                if constexpr (Variant::cohesive) to.add(b + Sum::attraction, attraction[l], opposite);
                if constexpr (Variant::relative_rolling) to.add(b + Sum::rolling, rolling[l], opposite);
            }
        }
    }

    /// Attraction of contacts that cannot leave their overlap within the step is the constant one, so that nothing has
    /// to be solved; the others within its range are listed. Returns 1 for those, else 0.
    template <class C>
    RECOAT_HD T attract(std::size_t k, int lanes, const TileMeeting<T>& m, T speed, const C& c, std::size_t& near,
                        Row* rows, Booked& booked, const T& counts) const {
        using std::abs;
        // How far they may come apart: at their speed, and by three times what their velocities changed by in the last
        // step.
        const T way = T(Real(w.time_step)) * (T(Real(1.5)) * abs(speed) + T(Real(3)) * m.spin_change) +
                      T(Real(0.1) * w.attraction.minimum_separation);
        const bool exact = w.impulse.index() < 3;  // a discrete gradient; the other schemes know no such constant
        const auto held = m.separation + way < T(Real(exact ? 0 : -1));
        const auto listed = (m.separation <= T(Real(w.attraction.cut_off)) + way) & !held;
        const T force = select(held, T(c.attraction_contact), T(Real(0)));
        const T push = T(Real(w.time_step)) * force;
        S::rows(push * m.normal.x, push * m.normal.y, push * m.normal.z, T(Real(0)), rows);
        keep(w.last_attraction, k, lanes, force);
        if constexpr (Partner::is_wall) booked.wall += counts * partner.wall_power(force * m.normal);
        unsigned bits = S::bits(listed) & ((1u << lanes) - 1);
        if (bits != 0) list(k, bits, m, near);
        return select(listed, T(Real(1)), T(Real(0)));
    }

    RECOAT_HD void list(std::size_t k, unsigned bits, const TileMeeting<T>& m, std::size_t& near) const {
        Real x[width], y[width], z[width], s[width];
        S::store(x, m.normal.x);
        S::store(y, m.normal.y);
        S::store(z, m.normal.z);
        S::store(s, m.separation);
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
