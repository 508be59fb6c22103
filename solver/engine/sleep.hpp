#pragma once

#include <algorithm>

#include "solver/engine/sleep_choice.hpp"

namespace recoat {

/// Decides which particles of a snapshot sleep and when that has to be decided anew [docs/decisions/0011-sleep.md].
/// A sleeper neither moves nor turns, and its contacts stay as they are.
template <class Space>
class Sleep {
public:
    /// `smallest`: radius of the smallest particle [m].
    Sleep(const EngineSetup& setup, double smallest)
        : setup_(setup), rule_(sleep_rule(setup, smallest)), wall_distance_(2 * setup.diameter) {}

    /// Step of the next look after that of `s`.
    [[nodiscard]] std::int64_t next_look(const SnapshotOf<Space>& s) const { return rule_.next(s.step, some_sleep(s)); }
    [[nodiscard]] bool look_is_due(const SnapshotOf<Space>& s) const { return rule_.due(s.step, some_sleep(s)); }

    /// Flags of the sleepers, [N]; null where it does not pay to let any sleep.
    const std::int32_t* choose(Space& space, SnapshotOf<Space>& s, const FarList<Space>& far, const WallAnchor* walls) {
        const std::size_t n = s.particles.size();
        const Quiet quiet(s, rule_);
        if (!applies(s) || far.begin.empty()) return nullptr;
        const MovingWallSearch search{walls, s.walls.now().size(), s.step, setup_.time_step, wall_distance_};
        const std::size_t sleepers = choice_.choose(space, s, far, quiet, search);
        s.awake = n;
        if (sleepers < std::max(least_sleepers, n / least_part)) return nullptr;
        s.awake = n - sleepers;
        return choice_.asleep();
    }

    /// After the sort: stops those that have been chosen.
    void fall_asleep(Space& space, SnapshotOf<Space>& s) const {
        s.sorted_at = s.step;
        if (!applies(s)) return;
        // What is left of their motion counts as lost in contacts.
        if (some_sleep(s)) s.totals.lost_normal += stop_motion(space, s, s.awake, any_sizes(setup_.model));
        s.calm = static_cast<std::int64_t>(count_quiet(space, s, Quiet(s, rule_)));
    }

    /// Takes note of who has moved. Returns whether to choose the sleepers anew: because those there are have been
    /// disturbed, or because there could be many more.
    bool look(Space& space, SnapshotOf<Space>& s) const {
        if (!applies(s)) return false;
        note_motion(space, s, rule_, Period(setup_.y_period));
        const Quiet quiet(s, rule_);
        if (sleepers_disturbed(space, s, quiet)) return true;
        const std::int64_t since = s.step - s.sorted_at;
        if (since < looks_between_choices * rule_.look_for_first) return false;
        // Those that were quiet then and still had to stay awake are asked again only now and then.
        const std::int64_t asked = since < rests_between_choices * rule_.rest ? s.calm : 0;
        const auto calmer = static_cast<std::int64_t>(count_quiet(space, s, quiet)) - asked;
        return calmer > static_cast<std::int64_t>(std::max(least_sleepers / 4, s.awake / 10));
    }

    /// Whether one that is not quiet has come near a sleeper.
    bool disturbed(Space& space, const SnapshotOf<Space>& s) const {
        return sleepers_disturbed(space, s, Quiet(s, rule_));
    }

    /// Whether a wall may have come near sleepers since they were chosen.
    [[nodiscard]] bool wall_is_near(const SnapshotOf<Space>& s) const {
        if (!some_sleep(s)) return false;
        const double way = s.walls.fastest() * static_cast<double>(s.step - s.sorted_at) * setup_.time_step;
        return way > 0.5 * wall_distance_;
    }

private:
    [[nodiscard]] static bool some_sleep(const SnapshotOf<Space>& s) { return s.awake < s.particles.size(); }
    static constexpr std::size_t least_sleepers = 64;  ///< fewer are not worth the sorting, ...
    static constexpr std::size_t least_part = 20;      ///< ... nor is a smaller part of all (one of so many)
    static constexpr std::int64_t looks_between_choices = 4, rests_between_choices = 2;

    [[nodiscard]] bool applies(const SnapshotOf<Space>& s) const {
        return rule_.look > 0 && s.particles.size() >= 2 * least_sleepers;
    }

    EngineSetup setup_;
    SleepRule rule_;
    SleepChoice<Space> choice_;
    double wall_distance_;  ///< of sleepers from moving walls, when they are chosen [m]
};

}  // namespace recoat
