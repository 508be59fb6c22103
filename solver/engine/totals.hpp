#pragma once

#include "solver/engine/contacts.hpp"
#include "solver/execution/reductions.hpp"

namespace recoat {

/// Energies since the start [J].
struct Totals {
    double lost_normal = 0, lost_tangential = 0, lost_rolling = 0, wall_work = 0, removed_with_walls = 0;

    /// Adds what contacts and particles (`rolling`, [N]) have counted.
    template <class Space>
    void add(Space& space, const ContactArrays<Space>& contacts,
             const typename Space::template Array<double>& rolling) {
        const auto sums = space.reduce(sum_of_entries(contacts.lost_normal), sum_of_entries(contacts.lost_tangential),
                                       sum_of_entries(contacts.wall_work), sum_of_entries(rolling));
        lost_normal += sums[0];
        lost_tangential += sums[1];
        wall_work += sums[2];
        lost_rolling += sums[3];
    }

    /// Adds a share of other energies.
    void add(const Totals& other, double share) {
        lost_normal += share * other.lost_normal;
        lost_tangential += share * other.lost_tangential;
        lost_rolling += share * other.lost_rolling;
        wall_work += share * other.wall_work;
        removed_with_walls += share * other.removed_with_walls;
    }
};

/// Sets what contacts and particles have counted to 0.
template <class Space>
void clear_counters(Space& space, ContactArrays<Space>& contacts, typename Space::template Array<double>& rolling) {
    const std::size_t n = contacts.size();
    const ContactView c = contacts.view();
    space.for_each(n,
                   [=] RECOAT_LAMBDA(std::size_t k) { c.lost_normal[k] = c.lost_tangential[k] = c.wall_work[k] = 0; });
    space.fill(rolling, rolling.size(), 0.0);
}

}  // namespace recoat
