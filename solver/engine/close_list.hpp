#pragma once

#include <vector>

#include "solver/engine/contacts.hpp"
#include "solver/engine/execution.hpp"
#include "solver/engine/far_list.hpp"
#include "solver/engine/wall.hpp"

namespace recoat {

/// What a close list is made from.
struct CloseListInput {
    const std::vector<Row>& position;
    const std::vector<Wall>& walls;
    const FarList& far;
    double y_period;
    double range;  ///< pairs and walls with separation below this are listed [m]
    bool cohesive, relative_rolling;
};

/// Lists the pairs that can touch or attract in the coming steps, and hands the history of `old` over to them.
/// `old` must be sorted in the present order of particles. Energies counted in `old` are not carried over.
Contacts make_close_list(OpenMP& space, const CloseListInput& input, const Contacts& old);

/// Renames the particles of `contacts` (old place -> new place) and sorts them anew; history keeps its meaning.
Contacts renamed(const Contacts& contacts, const std::vector<std::int32_t>& new_place);

/// Fills in which contacts every particle has.
void list_incidence(Contacts& contacts, std::size_t particles);

}  // namespace recoat
