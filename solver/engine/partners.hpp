#pragma once

#include <vector>

#include "solver/engine/engine.hpp"
#include "solver/engine/partner.hpp"
#include "solver/engine/snapshot.hpp"

namespace recoat {

/// Calls f(partner, first contact, number of contacts) for the pairs and for every wall.
template <class Sizes, class Function>
void visit_partners(const EngineSetup& setup, const Sizes& sizes, const std::vector<Wall>& walls, const Contacts& c,
                    const Function& f) {
    const double radius_arm = setup.model.lever_arm == LeverArm::radius ? 1 : 0;
    f(ParticlePartner<Sizes>{sizes, Period(setup.y_period), radius_arm}, std::size_t{0}, c.pairs);
    for (std::size_t w = 0; w < walls.size(); ++w) {
        const Wall& wall = walls[w];
        const std::size_t from = c.wall_begin[w], count = c.wall_begin[w + 1] - from;
        if (wall.kind == WallKind::plane)
            f(WallPartner<Sizes, PlaneShape>{sizes, PlaneShape(wall), wall.velocity, radius_arm}, from, count);
        else
            f(WallPartner<Sizes, BoxShape>{sizes, BoxShape(wall), wall.velocity, radius_arm}, from, count);
    }
}

}  // namespace recoat
