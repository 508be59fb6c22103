#pragma once

#include <algorithm>

#include "solver/engine/close_list.hpp"
#include "solver/engine/limits.hpp"
#include "solver/engine/particle_loops.hpp"
#include "solver/engine/sleep.hpp"
#include "solver/engine/spatial_sort.hpp"
#include "solver/engine/spread_of_ways.hpp"

namespace recoat {

/// Keeps the pair lists of a snapshot: a far list over cells, and close lists made from it, one of what moves and one
/// of what sleeps. Whenever the far list is made anew, particles are sorted in space, and who sleeps is chosen.
template <class Space>
class PairLists {
public:
    template <class T>
    using Array = typename Space::template Array<T>;

    /// `smallest`: radius of the smallest particle [m].
    PairLists(const EngineSetup& setup, double smallest) : setup_(setup), domain_(setup), sleep_(setup, smallest) {}

    /// To be called when the close list may have gone stale by the bound of the ways: makes it anew if by the ways
    /// themselves it has, or soon will. Throws as refresh().
    void renew(Space& space, SnapshotOf<Space>& s, const Array<WallAnchor>& walls) {
        const SpreadOfWays ways = ways_since_listed(space, s);
        s.travelled = 0.5 * ways.widest();
        const bool good = 0.5 * s.margin - s.travelled > (least_steps + 2) * s.last_travel;
        // Who has gone that far, though all together, may have left the domain: see sort().
        if (!good || ways.farthest() > skin()) refresh(space, s, walls);
    }

    /// Makes the close list of what moves anew, and all else where the far list has gone stale or `sort` says so.
    /// Throws SimulationFault when a particle has left the domain.
    void refresh(Space& space, SnapshotOf<Space>& s, const Array<WallAnchor>& walls, bool sort = false) {
        ++made_;
        s.totals.add(space, s.contacts, s.lost_rolling);
        clear_counters(space, s.contacts, s.lost_rolling);
        s.margin = std::clamp(approach_of_step(space, s) * setup_.skins.close_steps,
                              limits::least_margin * setup_.diameter, limits::most_margin * setup_.diameter);
        const std::size_t n = s.particles.size(), had_slept = n - s.awake;
        history_.awake.take(space, s.contacts, 0, s.awake);
        if (sort || far_is_stale(space, s)) {
            history_.asleep.take(space, s.dormant, s.awake, had_slept);
            this->sort(space, s, walls);
            const std::int32_t* order = sort_.order().data();
            if (had_slept > 0 || s.awake < n)
                make_close_list(space, input(s, walls, s.awake, n - s.awake, order), far_, history_, s.dormant);
            make_close_list(space, input(s, walls, 0, s.awake, order), far_, history_, s.contacts);
        } else {
            make_close_list(space, input(s, walls, 0, s.awake, nullptr), far_, history_, s.contacts);
        }
        space.fill(s.lost_rolling, s.awake, 0.0);
        // A processor adds contacts up while it goes through them.
        if constexpr (!Space::on_host) complete_list(space, s.contacts, setup_.model, s.awake, n);
        take_places(space, s);
        if (sleep_.disturbed(space, s)) refresh(space, s, walls, true);
    }

    /// Changes whenever lists, order of the particles or who sleeps do.
    [[nodiscard]] std::int64_t made() const { return made_; }

    /// Step at which to look who has come to rest or has been disturbed, the next after this.
    [[nodiscard]] std::int64_t next_look(const SnapshotOf<Space>& s) const { return sleep_.next_look(s); }

    /// Looks, if this is such a step.
    void look(Space& space, SnapshotOf<Space>& s, const Array<WallAnchor>& walls) {
        if (sleep_.look_is_due(s) && sleep_.look(space, s)) refresh(space, s, walls, true);
    }

    /// To be called when a wall begins to move otherwise: wakes whom it is near.
    void wall_driven(Space& space, SnapshotOf<Space>& s, const Array<WallAnchor>& walls) {
        refresh(space, s, walls, s.awake < s.particles.size());
    }

    /// To be called when a wall has gone: wakes everybody.
    void wall_removed(Space& space, SnapshotOf<Space>& s, const Array<WallAnchor>& walls) {
        rouse(space, s);
        refresh(space, s, walls, s.awake < s.particles.size());
    }

    /// Fills in what a saved snapshot leaves out.
    void restore(Space& space, SnapshotOf<Space>& s) {
        ++made_;
        const std::size_t n = s.particles.size(), count = s.walls.now().size();
        far_.build(space, s.far_reference, s.awake, skin(), setup_.y_min, setup_.y_period);
        list_offsets(space, s.contacts, 0, s.awake, count);
        list_offsets(space, s.dormant, s.awake, n - s.awake, count);
        if constexpr (!Space::on_host) complete_list(space, s.contacts, setup_.model, s.awake, n);
    }

private:
    static constexpr double least_steps = 3;  ///< for which a list that is nearly stale is kept

    [[nodiscard]] double range() const { return setup_.model.hamaker > 0 ? setup_.model.cut_off : 0; }
    [[nodiscard]] double skin() const { return range() + setup_.skins.far * setup_.diameter; }

    bool far_is_stale(Space& space, const SnapshotOf<Space>& s) const {
        if (s.far_reference.empty() || sleep_.wall_is_near(s)) return true;
        const SpreadOfWays ways = ways_since(space, s, s.far_reference);
        return range() + s.margin + ways.widest() > skin() || ways.farthest() > skin();
    }

    /// Of the particles, from their places then.
    SpreadOfWays ways_since(Space& space, const SnapshotOf<Space>& s, const Array<Row>& then) const {
        SpreadOfWays ways = spread_of_ways(space, s.particles.position.data(), then.data(), s.awake);
        if (s.awake < s.particles.size()) ways.include({});
        return ways;
    }

    /// Of all that the close list is about, since it was made.
    SpreadOfWays ways_since_listed(Space& space, const SnapshotOf<Space>& s) const {
        SpreadOfWays ways = ways_since(space, s, s.close_reference);
        const double time = static_cast<double>(s.step - s.listed_at) * setup_.time_step;
        for (const Wall& wall : s.walls.now())
            if (wall.active) ways.include(time * wall.velocity);
        return ways;
    }

    /// By how much two come closer in a step now, at most [m]: as since the last list, or as the fastest do.
    double approach_of_step(Space& space, const SnapshotOf<Space>& s) const {
        const std::int64_t steps = s.step - s.listed_at;
        if (steps > 0) return ways_since_listed(space, s).widest() / static_cast<double>(steps);
        return 2 * std::max(s.last_travel, s.walls.fastest() * setup_.time_step);
    }

    /// From where ways_since_listed() counts.
    void take_places(Space& space, SnapshotOf<Space>& s) const {
        s.listed_at = s.step;
        s.travelled = 0;
        s.close_reference.resize(s.awake);
        copy_rows(space, s.particles.position.data(), s.close_reference.data(), s.awake);
    }

    void sort(Space& space, SnapshotOf<Space>& s, const Array<WallAnchor>& walls) {
        require_inside(space, s);
        sort_(space, s.particles, skin(), setup_.y_min, setup_.y_period, sleep_.choose(space, s, far_, walls.data()));
        sort_.follow(space, s.rest);
        sleep_.fall_asleep(space, s);
        far_.build(space, s.particles.position, s.awake, skin(), setup_.y_min, setup_.y_period);
        space.copy(s.particles.position, s.far_reference);
    }

    [[nodiscard]] CloseListInput input(const SnapshotOf<Space>& s, const Array<WallAnchor>& walls, std::size_t begin,
                                       std::size_t count, const std::int32_t* old_place) const {
        return {s.particles.position.data(),
                begin,
                count,
                walls.data(),
                s.walls.now().size(),
                s.step,
                setup_.time_step,
                setup_.y_period,
                range() + s.margin,
                old_place};
    }

    void require_inside(Space& space, const SnapshotOf<Space>& s) const {
        if (all_inside(space, s.particles.position.data(), s.particles.size(), domain_)) return;
        Particles host;
        space.copy(s.particles.position, host.position);
        space.copy(s.particles.id, host.id);
        recoat::require_inside(host, setup_, s.step);
    }

    EngineSetup setup_;
    DomainCheck domain_;
    FarList<Space> far_;
    SpatialSort<Space> sort_;
    Sleep<Space> sleep_;
    ContactHistory<Space> history_;
    std::int64_t made_ = 0;
};

}  // namespace recoat
