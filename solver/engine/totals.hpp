#pragma once

#include <vector>

#include "solver/engine/contacts.hpp"

namespace recoat {

/// Energies since the start [J].
struct Totals {
    double lost_normal = 0, lost_tangential = 0, lost_rolling = 0, wall_work = 0, removed_with_walls = 0;

    /// Adds what contacts and particles have counted, in their order.
    void add(const Contacts& contacts, const std::vector<double>& rolling, bool relative_rolling) {
        for (std::size_t k = 0; k < contacts.size(); ++k) {
            lost_normal += contacts.lost_normal[k];
            lost_tangential += contacts.lost_tangential[k];
            wall_work += contacts.wall_work[k];
            if (relative_rolling) lost_rolling += contacts.rolling[k].w;
        }
        for (const double lost : rolling) lost_rolling += lost;
    }
};

}  // namespace recoat
