#include "solver/engine/spatial_sort.hpp"

#include "solver/engine/close_list.hpp"
#include "solver/engine/fault.hpp"

namespace recoat {

void sort_in_space(Snapshot& s, const EngineSetup& setup, double skin) {
    require_inside(s.particles, setup, s.step);
    fold(s.particles, setup.y_min, setup.y_period);
    const auto order = spatial_order(s.particles.position, s.particles.id, skin, setup.y_min, setup.y_period);
    permute(s.particles, order);
    s.contacts = renamed(s.contacts, inverse(order));
}

}  // namespace recoat
