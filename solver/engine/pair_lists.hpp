#pragma once

#include <algorithm>

#include "solver/engine/close_list.hpp"
#include "solver/engine/limits.hpp"
#include "solver/engine/particle_loops.hpp"
#include "solver/engine/spatial_sort.hpp"

namespace recoat {

/// Keeps the pair lists of a snapshot: a far list over cells, and a close list made from it. Particles are sorted in
/// space whenever the far list is made anew.
template <class Space>
class PairLists {
public:
    template <class T>
    using Array = typename Space::template Array<T>;

    explicit PairLists(const EngineSetup& setup) : setup_(setup), domain_(setup) {}

    /// Makes the close list anew, and the far list and the order of the particles where they have gone stale.
    /// Throws SimulationFault when a particle has left the domain.
    void refresh(Space& space, SnapshotOf<Space>& s, const Array<WallAnchor>& walls) {
        s.totals.add(space, s.contacts, s.lost_rolling);
        clear_counters(space, s.contacts, s.lost_rolling);
        const double speed = std::max(s.last_travel, s.walls.fastest() * setup_.time_step);
        s.margin = std::clamp(2 * speed * setup_.skins.close_steps, limits::least_margin * setup_.diameter,
                              limits::most_margin * setup_.diameter);
        const bool sorted = far_is_stale(space, s);
        if (sorted) {
            require_inside(space, s);
            sort_(space, s.particles, skin(), setup_.y_min, setup_.y_period);
            far_.build(space, s.particles.position, skin(), setup_.y_min, setup_.y_period);
            space.copy(s.particles.position, s.far_reference);
        }
        const CloseListInput input{s.particles.position.data(),
                                   s.particles.size(),
                                   walls.data(),
                                   s.walls.now().size(),
                                   s.step,
                                   setup_.time_step,
                                   setup_.y_period,
                                   range() + s.margin,
                                   setup_.model.hamaker > 0,
                                   setup_.model.rolling_form == RollingForm::relative,
                                   sorted ? sort_.order().data() : nullptr};
        make_close_list(space, input, far_, history_, s.contacts);
        s.travelled = 0;
    }

    /// Fills in what a saved snapshot leaves out.
    void restore(Space& space, SnapshotOf<Space>& s) {
        far_.build(space, s.far_reference, skin(), setup_.y_min, setup_.y_period);
        complete_list(space, s.contacts, setup_.model, s.particles.size(), s.walls.now().size());
    }

private:
    [[nodiscard]] double range() const { return setup_.model.hamaker > 0 ? setup_.model.cut_off : 0; }
    [[nodiscard]] double skin() const { return range() + setup_.skins.far * setup_.diameter; }

    bool far_is_stale(Space& space, const SnapshotOf<Space>& s) const {
        if (s.far_reference.empty()) return true;
        const double moved =
            largest_displacement(space, s.particles.position.data(), s.far_reference.data(), s.particles.size());
        return range() + s.margin + 2 * moved > skin();
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
    ContactHistory<Space> history_;
};

}  // namespace recoat
