#pragma once

#include <limits>

#include "solver/engine/tile_geometry.hpp"

namespace recoat {

/// Moves the particles of a tile. Most of it is done on rows, one particle at a time; the roots of rolling resistance
/// for a pack of particles at once.
template <class Set, class Variant>
struct ParticleTile {
    using S = Simd<Set>;
    using Row = typename S::Row;
    using Double = typename S::Double;
    using Work = TileWork<Variant>;
    using Sum = SumLayout<Variant>;
    static constexpr int group = S::doubles;

    const Work& w;
    Row gravity, step, half_step;  ///< their fourth numbers are 0, so that radii and loads stay what they are

    explicit RECOAT_HD ParticleTile(const Work& work)
        : w(work),
          gravity(S::row_of(w.gravity.x, w.gravity.y, w.gravity.z, 0)),
          step(thrice(w.time_step)),
          half_step(thrice(0.5 * w.time_step)) {}

    /// From the sums to velocities and spins; positions of particles without near contacts, a list of the others from
    /// place `near_begin` on. Clears the sums.
    RECOAT_HD void advance(TileRange range, std::size_t near_begin, TileTally& tally) const {
        if (range.begin == range.end) return;
        Row lost = S::spread(0);
        Fastest fastest;
        std::size_t i = range.begin;
        for (; i + group <= range.end; i += group) together<true>(i, group, lost, fastest);
        if (i < range.end) together<false>(i, static_cast<int>(range.end - i), lost, fastest);
        if constexpr (Variant::cohesive) list_near(range, near_begin, tally);
        w.lost_rolling[range.begin] += S::sum3(lost);
        fastest.tell(tally);
    }

    /// Mean velocities of the step as the impulses found so far make them, of the particles at the places `range` of
    /// the list of those with near contacts; in the place of the velocities that contacts see.
    RECOAT_HD void foresee(TileRange range) const {
        if constexpr (Variant::cohesive) {
            for (std::size_t n = range.begin; n < range.end; ++n) {
                const auto i = static_cast<std::size_t>(w.near_particles[n]);
                const double* sum = sums(i);
                S::store(w.contact_velocity + 4 * i,
                         S::multiply_add(S::row(sum + Sum::attraction), thrice(0.5 * inverse_mass(i)),
                                         S::row(w.velocity + 4 * i)));
            }
        }
    }

    /// Impulses of the near contacts of such particles, and the positions that were left out.
    RECOAT_HD void finish(TileRange range, TileTally& tally) const {
        if constexpr (Variant::cohesive) {
            const bool half = w.impulse.index() < 3;
            for (std::size_t n = range.begin; n < range.end; ++n) {
                const auto i = static_cast<std::size_t>(w.near_particles[n]);
                double* sum = sums(i);
                sum[7] = 0;
                const Row impulse = S::multiply(S::row(sum + Sum::attraction), thrice(inverse_mass(i)));
                S::store(sum + Sum::attraction, S::spread(0));
                late(i, impulse, half ? 0.5 : 1.0, tally);
            }
        }
    }

private:
    /// Without a branch: whether a particle is near is hard to foresee.
    RECOAT_HD void list_near(TileRange range, std::size_t near_begin, TileTally& tally) const {
        std::size_t place = near_begin;
        for (std::size_t i = range.begin; i < range.end; ++i) {
            w.near_particles[place] = static_cast<std::int32_t>(i);
            place += sums(i)[7] > 0 ? 1 : 0;
        }
        tally.near_particles = place - near_begin;
    }

    static RECOAT_HD Row thrice(double x) { return S::row_of(x, x, x, 0); }
    RECOAT_HD double* sums(std::size_t i) const { return w.sums + Sum::size * i; }
    RECOAT_HD double radius(std::size_t i) const { return w.position[4 * i + 3]; }
    RECOAT_HD double inverse_mass(std::size_t i) const { return w.sizes.inverse_mass_of(radius(i)); }

    /// Squared speeds of packs of particles.
    struct Fastest {
        Double square = Double(0.0);
        Double unbounded = Double(0.0);  ///< not a number once one of them is not finite

        RECOAT_HD void add(const Row* velocity) {
            const Double now = squares(velocity);
            square = larger(square, now);
            unbounded = unbounded + Double(0.0) * now;
        }
        RECOAT_HD void tell(TileTally& tally) const {
            const bool finite = S::sum(unbounded) == 0;
            const double most = finite ? S::highest(square) : std::numeric_limits<double>::infinity();
            if (!(most <= tally.largest_square)) tally.largest_square = most;
        }
    };

    /// Squared lengths of a pack of rows without their fourth numbers.
    static RECOAT_HD Double squares(const Row* rows) {
        Double x, y, z, rest;
        S::packs(rows, x, y, z, rest);
        return x * x + y * y + z * z;
    }

    /// A pack of particles; all of it is there if `full`, else the first `count`.
    template <bool full>
    RECOAT_HD void together(std::size_t i, int count, Row& lost, Fastest& fastest) const {
        Row seen_spin[group];
        turn<full>(i, count, seen_spin, lost);
        Row velocity[group], mean[group];
        RECOAT_UNROLL
        for (int l = 0; l < group; ++l) {
            velocity[l] = mean[l] = S::spread(0);
            if (full || l < count) push(i + std::size_t(l), seen_spin[l], velocity[l], mean[l]);
        }
        fastest.add(velocity);
        if constexpr (Variant::cohesive) fastest.add(mean);
    }

    /// Turns particles and clears their torques; `lost` gains what rolling resistance takes, in its first three
    /// numbers. `seen` is the spin at the time of the positions.
    template <bool full>
    RECOAT_HD void turn(std::size_t i, int count, Row* seen, Row& lost) const {
        Row before[group], spin[group];
        double load[group] = {}, inverse_inertia[group] = {};
        RECOAT_UNROLL
        for (int l = 0; l < group; ++l) {
            before[l] = spin[l] = S::spread(0);
            if (!full && l >= count) continue;
            const std::size_t at = i + std::size_t(l);
            double* sum = sums(at);
            inverse_inertia[l] = w.sizes.inverse_inertia_of(radius(at));
            before[l] = S::row(w.spin + 4 * at);
            // The fourth number of a torque is a count.
            Row torque = S::row(sum + 4);
            if constexpr (Variant::relative_rolling) {
                const Row rolling = S::row(sum + Sum::rolling);
                torque = S::add(torque, rolling);
                spin[l] = S::multiply_add(torque, thrice(w.time_step * inverse_inertia[l]), before[l]);
                lost = S::add(
                    lost, S::multiply(S::multiply(rolling, thrice(-0.5 * w.time_step)), S::add(before[l], spin[l])));
                S::store(sum + Sum::rolling, S::spread(0));
            } else {
                spin[l] = S::multiply_add(torque, thrice(w.time_step * inverse_inertia[l]), before[l]);
                load[l] = (w.own_rolling_length * w.sizes.radius_of(radius(at)) + w.own_rolling_constant) * sum[3];
            }
        }
        if constexpr (!Variant::relative_rolling) resist(load, inverse_inertia, before, spin, lost);
        RECOAT_UNROLL
        for (int l = 0; l < group; ++l) {
            if (!full && l >= count) continue;
            S::store(w.spin + 4 * (i + std::size_t(l)), spin[l]);
            seen[l] = S::multiply_add(S::subtract(spin[l], before[l]), S::spread(0.5), spin[l]);
        }
    }

    /// Rolling resistance of a pack of particles against their own spins.
    RECOAT_HD void resist(const double* load, const double* inverse_inertia, const Row* before, Row* spin,
                          Row& lost) const {
        const Double square = squares(spin), mobility = S::load(inverse_inertia);
        double kept[group];
        const RollingOf<double> rolling{static_cast<double>(w.law.rolling.friction)};
        S::store(kept, rolling.kept(square, S::load(load), mobility, Double(w.time_step)));
        RECOAT_UNROLL
        for (int l = 0; l < group; ++l) {
            if (!(inverse_inertia[l] > 0)) continue;  // nobody there
            const Row free = spin[l];
            spin[l] = S::multiply(free, S::spread(kept[l]));
            double inertia;
            if constexpr (Variant::equal)
                inertia = w.sizes.inertia;
            else
                inertia = 1 / inverse_inertia[l];
            const Row change = S::multiply(S::subtract(free, spin[l]), S::spread(0.5 * inertia));
            lost = S::multiply_add(change, S::add(before[l], spin[l]), lost);
        }
    }

    /// Accelerates a particle and, unless it has near contacts, moves it; `velocity` and `mean` become what it has and
    /// what it moves with.
    RECOAT_HD void push(std::size_t i, Row seen_spin, Row& velocity, Row& mean) const {
        double* sum = sums(i);
        const double mobility = inverse_mass(i);
        const Row acceleration = S::multiply_add(S::row(sum), thrice(mobility), gravity);
        velocity = S::multiply_add(acceleration, step, S::row(w.velocity + 4 * i));
        S::store(sum, S::spread(0));
        if constexpr (Variant::cohesive) {
            const double near = sum[7];
            const Row impulse = S::multiply(S::row(sum + Sum::attraction), thrice(mobility));
            S::store(sum + 4, S::row_of(0, 0, 0, near));
            if (near > 0) {
                S::store(w.velocity + 4 * i, velocity);
                S::store(w.acceleration + 4 * i, acceleration);
                S::store(w.contact_spin + 4 * i, seen_spin);
                return;
            }
            S::store(sum + Sum::attraction, S::spread(0));
            move(i, velocity, acceleration, impulse, 0.5, seen_spin, mean);
        } else {
            S::store(sum + 4, S::spread(0));
            const Row seen = S::multiply_add(acceleration, half_step, velocity);
            S::store(w.velocity + 4 * i, velocity);
            S::store(w.position + 4 * i, S::multiply_add(velocity, step, S::row(w.position + 4 * i)));
            show(i, seen, seen_spin);
        }
    }

    /// The same for a particle whose impulse was found later.
    RECOAT_HD void late(std::size_t i, Row impulse, double share, TileTally& tally) const {
        Row velocity = S::row(w.velocity + 4 * i), mean;
        move(i, velocity, S::row(w.acceleration + 4 * i), impulse, share, S::row(w.contact_spin + 4 * i), mean);
        measure(velocity, tally);
        measure(mean, tally);
    }

    /// Adds `impulse` to the velocity and moves the particle, by the velocity before it and this `share` of the
    /// impulse: half of it makes the work of the attraction exact [docs/physics.md section 2.5].
    RECOAT_HD void move(std::size_t i, Row& velocity, Row acceleration, Row impulse, double share, Row seen_spin,
                        Row& mean) const {
        mean = S::multiply_add(impulse, S::spread(share), velocity);
        velocity = S::add(velocity, impulse);
        S::store(w.velocity + 4 * i, velocity);
        S::store(w.position + 4 * i, S::multiply_add(mean, step, S::row(w.position + 4 * i)));
        // A bound of the change of the velocity in this step goes where the spin has no number.
        double change[4];
        S::store(change, S::multiply_add(acceleration, step, impulse));
        const double bound = std::fabs(change[0]) + std::fabs(change[1]) + std::fabs(change[2]);
        show(i, S::multiply_add(acceleration, half_step, velocity), S::with_fourth(seen_spin, bound));
    }

    /// Writes what contacts see: velocity and spin at the time of the positions.
    RECOAT_HD void show(std::size_t i, Row velocity, Row spin) const {
        S::store(w.contact_spin + 4 * i, spin);
        if constexpr (Variant::single)
            S::store(w.motion + 8 * i, S::motion_of(velocity, spin));
        else
            S::store(w.contact_velocity + 4 * i, velocity);
    }

    static RECOAT_HD void measure(Row velocity, TileTally& tally) {
        const double square = S::sum3(S::multiply(velocity, velocity));
        // Compared this way, what is not a number counts as infinitely fast.
        if (!(square <= tally.largest_square))
            tally.largest_square = square > 0 ? square : std::numeric_limits<double>::infinity();
    }
};

}  // namespace recoat
