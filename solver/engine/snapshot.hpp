#pragma once

#include <vector>

#include "solver/engine/contacts.hpp"
#include "solver/engine/engine.hpp"
#include "solver/engine/moving_walls.hpp"
#include "solver/engine/particles.hpp"
#include "solver/engine/totals.hpp"
#include "solver/execution/openmp.hpp"

namespace recoat {

/// Everything that changes while an engine runs. Saved whole, a restored engine continues to the bit: the order of the
/// particles and the age of the pair lists are part of it, because sums run in their order.
template <class Space>
struct SnapshotOf {
    template <class T>
    using Array = typename Space::template Array<T>;

    std::int64_t step = 0;
    bool fresh = true;      ///< not yet started: no lists, velocities at the time of the positions
    std::size_t awake = 0;  ///< the first of the particles; the others neither move nor turn
    ParticleArrays<Space> particles;
    MovingWalls walls;
    ContactArrays<Space> contacts;  ///< of the awake with each other, with sleepers and with walls
    ContactArrays<Space> dormant;   ///< of sleepers with each other and with walls, as they were
    Array<Row> rest;                ///< places near which particles have stayed [m], and since which step
    Array<Row> far_reference;       ///< positions when the far list was made
    Array<Row> close_reference;     ///< [awake] the same for the close list
    Array<double> lost_rolling;     ///< [awake] energy taken by rolling resistance since the list was made [J]
    Totals totals;
    std::int64_t sorted_at = 0;  ///< step in which the far list was made and who sleeps was chosen
    std::int64_t calm = 0;       ///< awake particles that were quiet then
    double margin = 0;           ///< the close list holds until particles have come closer by this [m]
    std::int64_t listed_at = 0;  ///< step in which it was made
    double travelled = 0;        ///< half of a bound of how much any two have come closer since then [m]
    double last_travel = 0;      ///< the same for the last step [m]
    double largest_overlap = 0;  ///< [m]

    /// Calls f(of this, of the other) for every array that a checkpoint holds.
    template <class Other, class Function>
    void each_saved(Other& other, const Function& f) {
        particles.each_saved(other.particles, f);
        contacts.each_saved(other.contacts, f);
        dormant.each_saved(other.dormant, f);
        f(rest, other.rest);
        f(far_reference, other.far_reference);
        f(close_reference, other.close_reference);
        f(lost_rolling, other.lost_rolling);
    }
};

/// A snapshot where the host can look at it.
using Snapshot = SnapshotOf<OpenMP>;
using Particles = ParticleArrays<OpenMP>;
using Contacts = ContactArrays<OpenMP>;

/// Copies all that a checkpoint holds; `copy(from, to)` copies one array between the spaces.
template <class From, class To, class Copy>
void copy_snapshot(SnapshotOf<From>& from, SnapshotOf<To>& to, const Copy& copy) {
    from.each_saved(to, copy);
    to.step = from.step;
    to.fresh = from.fresh;
    to.walls = from.walls;
    to.awake = from.awake;
    to.contacts.pairs = from.contacts.pairs;
    to.contacts.wall_begin = from.contacts.wall_begin;
    to.dormant.pairs = from.dormant.pairs;
    to.dormant.wall_begin = from.dormant.wall_begin;
    to.sorted_at = from.sorted_at;
    to.calm = from.calm;
    to.totals = from.totals;
    to.margin = from.margin;
    to.listed_at = from.listed_at;
    to.travelled = from.travelled;
    to.last_travel = from.last_travel;
    to.largest_overlap = from.largest_overlap;
}

/// The state before the first step.
Snapshot initial_snapshot(const ParticleTable& table, std::vector<Wall> walls);

/// To and from named flat arrays; the latter throws InputError when one is missing.
EngineState saved(const Snapshot& snapshot);
Snapshot loaded(const EngineState& state);

double smallest_radius(const Particles& particles);
bool equal_radii(const Particles& particles);

/// Particles in order of identity, y folded.
ParticleTable table_of(const Particles& particles, const EngineSetup& setup);

}  // namespace recoat
