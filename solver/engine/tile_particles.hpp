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

    /// From the sums to velocities and spins; positions of particles without near contacts. Clears the sums.
    RECOAT_HD void advance(TileRange range, TileTally& tally) const {
        Row lost = S::spread(0);
        for (std::size_t i = range.begin; i < range.end; i += group) {
            const int count = i + group <= range.end ? group : static_cast<int>(range.end - i);
            turn(i, count, lost);
            for (int l = 0; l < count; ++l) push(i + std::size_t(l), tally);
        }
        if (range.begin < range.end) w.lost_rolling[range.begin] += S::sum3(lost);
    }

    /// Impulses of the near contacts, and the positions that were left out.
    RECOAT_HD void finish(TileRange range, TileTally& tally) const {
        if constexpr (Variant::cohesive) {
            const bool half = w.impulse.index() < 3;
            for (std::size_t i = range.begin; i < range.end; ++i) {
                double* sum = sums(i);
                if (!(sum[7] > 0)) continue;
                sum[7] = 0;
                const Row impulse = S::multiply(S::row(sum + Sum::attraction), thrice(inverse_mass(i)));
                S::store(sum + Sum::attraction, S::spread(0));
                move(i, S::row(w.velocity + 4 * i), S::row(w.acceleration + 4 * i), impulse, half ? 0.5 : 1.0, tally);
            }
        }
    }

private:
    static RECOAT_HD Row thrice(double x) { return S::row_of(x, x, x, 0); }
    RECOAT_HD double* sums(std::size_t i) const { return w.sums + Sum::size * i; }
    RECOAT_HD double radius(std::size_t i) const { return w.position[4 * i + 3]; }
    RECOAT_HD double inverse_mass(std::size_t i) const { return w.sizes.inverse_mass_of(radius(i)); }

    /// Turns `count` particles and clears their torques; `lost` gains what rolling resistance takes, in its first three
    /// numbers.
    RECOAT_HD void turn(std::size_t i, int count, Row& lost) const {
        Row before[group], spin[group];
        double square[group] = {}, load[group] = {}, inverse_inertia[group] = {};
        for (int l = 0; l < count; ++l) {
            const std::size_t at = i + std::size_t(l);
            double* sum = sums(at);
            inverse_inertia[l] = w.sizes.inverse_inertia_of(radius(at));
            before[l] = S::row(w.spin + 4 * at);
            // The fourth number of a torque is a count.
            Row torque = S::row(sum + 4);
            if constexpr (Variant::relative_rolling) torque = S::add(torque, S::row(sum + Sum::rolling));
            spin[l] = S::multiply_add(torque, thrice(w.time_step * inverse_inertia[l]), before[l]);
            square[l] = S::sum3(S::multiply(spin[l], spin[l]));
            load[l] = (w.own_rolling_length * w.sizes.radius_of(radius(at)) + w.own_rolling_constant) * sum[3];
        }
        if constexpr (Variant::relative_rolling) {
            for (int l = 0; l < count; ++l) {
                double* rolling = sums(i + std::size_t(l)) + Sum::rolling;
                lost = S::add(lost, S::multiply(S::multiply(S::row(rolling), thrice(-0.5 * w.time_step)),
                                                S::add(before[l], spin[l])));
                S::store(rolling, S::spread(0));
            }
        } else {
            double kept[group];
            const RollingOf<double> rolling{static_cast<double>(w.law.rolling.friction)};
            S::store(kept, rolling.kept(S::load(square), S::load(load), S::load(inverse_inertia), Double(w.time_step)));
            for (int l = 0; l < count; ++l) {
                const Row free = spin[l];
                spin[l] = S::multiply(free, S::spread(kept[l]));
                const Row change = S::multiply(S::subtract(free, spin[l]), S::spread(0.5 / inverse_inertia[l]));
                lost = S::add(lost, S::multiply(change, S::add(before[l], spin[l])));
            }
        }
        for (int l = 0; l < count; ++l) {
            const std::size_t at = i + std::size_t(l);
            S::store(w.spin + 4 * at, spin[l]);
            S::store(w.contact_spin + 4 * at,
                     S::multiply_add(S::subtract(spin[l], before[l]), S::spread(0.5), spin[l]));
        }
    }

    RECOAT_HD void push(std::size_t i, TileTally& tally) const {
        double* sum = sums(i);
        const double mobility = inverse_mass(i);
        const Row acceleration = S::multiply_add(S::row(sum), thrice(mobility), gravity);
        const Row velocity = S::multiply_add(acceleration, step, S::row(w.velocity + 4 * i));
        S::store(sum, S::spread(0));
        if constexpr (Variant::cohesive) {
            const bool near = sum[7] > 0;
            const Row impulse = S::multiply(S::row(sum + Sum::attraction), thrice(mobility));
            S::store(sum + 4, S::row_of(0, 0, 0, sum[7]));
            if (near) {
                S::store(w.velocity + 4 * i, velocity);
                S::store(w.acceleration + 4 * i, acceleration);
                measure(velocity, tally);
                return;
            }
            S::store(sum + Sum::attraction, S::spread(0));
            move(i, velocity, acceleration, impulse, 0.5, tally);
        } else {
            S::store(sum + 4, S::spread(0));
            move(i, velocity, acceleration, S::spread(0), 1, tally);
        }
    }

    /// Adds `impulse` to the velocity and moves the particle, by the velocity before it and this `share` of the
    /// impulse: half of it makes the work of the attraction exact [docs/physics.md section 2.5].
    RECOAT_HD void move(std::size_t i, Row velocity, Row acceleration, Row impulse, double share,
                        TileTally& tally) const {
        const Row after = S::add(velocity, impulse);
        const Row mean = S::multiply_add(impulse, S::spread(share), velocity);
        const Row seen = S::multiply_add(acceleration, half_step, after);
        S::store(w.velocity + 4 * i, after);
        S::store(w.position + 4 * i, S::multiply_add(mean, step, S::row(w.position + 4 * i)));
        show(i, seen, S::add(S::multiply(acceleration, step), impulse));
        measure(after, tally);
        if constexpr (Variant::cohesive) measure(mean, tally);
    }

    /// Writes what contacts see: the velocity and spin at the time of the positions and, where attraction asks for it,
    /// a bound of the change of the velocity in this step, in the place of the spin's fourth number.
    RECOAT_HD void show(std::size_t i, Row velocity, Row change) const {
        double* spin = w.contact_spin + 4 * i;
        if constexpr (Variant::cohesive) {
            double c[4];
            S::store(c, change);
            spin[3] = std::fabs(c[0]) + std::fabs(c[1]) + std::fabs(c[2]);
        }
        if constexpr (Variant::single)
            S::store(w.motion + 8 * i, S::motion_of(velocity, S::row(spin)));
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
