#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "solver/contact/impulse.hpp"
#include "solver/engine/engine.hpp"
#include "solver/engine/partner.hpp"

namespace recoat {

/// Pairs whose attraction a processor takes for the constant of the overlap because they cannot leave it within the
/// step [docs/decisions/0013-impulses-see-each-other.md], and those of them that have left it all the same.
struct HeldPairs {
    std::int64_t held = 0, left = 0;
    double missed = 0;    ///< work of the attraction that those were not charged for [J]
    double furthest = 0;  ///< separation of the one that went furthest [m]

    void add(const HeldPairs& other) {
        held += other.held;
        left += other.left;
        missed += other.missed;
        furthest = std::max(furthest, other.furthest);
    }
};

/// Makes one step and counts those of it, by what a checkpoint holds. Spheres of one size only.
class HeldPairsOfStep {
public:
    HeldPairsOfStep(Engine& engine, const EngineSetup& setup) : engine_(engine), setup_(setup) {}

    HeldPairs operator()() {
        const Places before = places();
        engine_.advance(1);
        const Places now = places();
        const EngineState state = engine_.save();
        const std::vector<double>& attraction = state.reals.at("contacts/attraction");
        const std::vector<std::int64_t>&first = state.integers.at("contacts/first"),
              &second = state.integers.at("contacts/second"), &id = state.integers.at("particles/id");
        const auto name = [&](std::int64_t place) { return place < 0 ? place : id[static_cast<std::size_t>(place)]; };
        const EqualSizes sizes = equal_sizes(setup_.model, now.radius);
        HeldPairs found;
        for (std::size_t k = 0; k < first.size(); ++k) {
            const Coefficients& c = second[k] < 0 ? sizes.wall : sizes.pair;
            // A pair less deep is always solved, and one that leaves never gets this force from that but for
            // the error of the solve.
            const double surely = 0.1 * setup_.model.minimum_separation +
                                  2 * path_per_force<double>(c, setup_.time_step) * c.attraction_gap;
            const std::int64_t i = name(first[k]), j = name(second[k]);
            if (attraction[k] != constant(c) || separation(before, i, j) > -surely) continue;
            ++found.held;
            const double apart = separation(now, i, j);
            if (!(apart > 0)) continue;
            ++found.left;
            found.missed +=
                (c.attraction_gap - c.attraction_contact) * std::min(apart, setup_.model.minimum_separation);
            found.furthest = std::max(found.furthest, apart);
        }
        return found;
    }

private:
    struct Places {
        std::vector<Vec3> centre;
        double radius;
        std::vector<Wall> walls;
    };

    [[nodiscard]] double constant(const Coefficients& c) const {
        return setup_.precision == Precision::mixed ? static_cast<double>(static_cast<float>(c.attraction_contact))
                                                    : c.attraction_contact;
    }
    [[nodiscard]] Places places() const {
        const ParticleTable table = engine_.particles();
        return {table.position, table.radius.front(), engine_.walls()};
    }
    [[nodiscard]] double separation(const Places& at, std::int64_t i, std::int64_t j) const {
        const Vec3 centre = at.centre[static_cast<std::size_t>(i)];
        if (j >= 0)
            return norm(Period(setup_.y_period).nearest(at.centre[static_cast<std::size_t>(j)] - centre)) -
                   2 * at.radius;
        const Wall& wall = at.walls[static_cast<std::size_t>(-1 - j)];
        return wall.kind == WallKind::plane ? PlaneShape(wall).meet(centre, at.radius).separation
                                            : BoxShape(wall).meet(centre, at.radius).separation;
    }

    Engine& engine_;
    EngineSetup setup_;
};

}  // namespace recoat
