#pragma once

#include <variant>

#include "solver/engine/tile_contacts.hpp"
#include "solver/engine/tile_near.hpp"
#include "solver/engine/tile_particles.hpp"
#include "solver/engine/tile_wall.hpp"

namespace recoat {

/// The loops of one variant for one instruction set. Only translation units that are compiled for that set include this
/// header; what they define outside of these templates has to be inline everywhere, or the linker might take a function
/// that other machines cannot run.
template <class Set, class Variant>
struct TileLoops {
    using Work = TileWork<Variant>;

    static void contacts(const Work& w, const Wall* wall, TileRange range, std::size_t near_begin, TileTally& tally) {
        with_partner(w, wall, [&](const auto& partner) {
            using Partner = std::decay_t<decltype(partner)>;
            ContactTile<Set, Variant, Partner>{w, partner}(range, near_begin, tally);
        });
    }
    static void particles(const Work& w, TileRange range, std::size_t near_begin, TileTally& tally) {
        ParticleTile<Set, Variant>(w).advance(range, near_begin, tally);
    }
    static void near(const Work& w, const Wall* wall, TileRange range) { solve<false>(w, wall, range); }
    static void foresee(const Work& w, TileRange range) { ParticleTile<Set, Variant>(w).foresee(range); }
    static void correct(const Work& w, const Wall* wall, TileRange range) { solve<true>(w, wall, range); }
    static void finish(const Work& w, TileRange range, TileTally& tally) {
        ParticleTile<Set, Variant>(w).finish(range, tally);
    }

private:
    template <bool again>
    static void solve(const Work& w, const Wall* wall, TileRange range) {
        if constexpr (Variant::cohesive) {
            with_partner(w, wall, [&](const auto& partner) {
                using Partner = std::decay_t<decltype(partner)>;
                const NearTile<Set, Variant, Partner> tile{w, partner};
                switch (w.impulse.index()) {
                    case 0:
                        return tile.template solve<again>(*std::get_if<0>(&w.impulse), range);
                    case 1:
                        return tile.template solve<again>(*std::get_if<1>(&w.impulse), range);
                    case 2:
                        return tile.template solve<again>(*std::get_if<2>(&w.impulse), range);
                    default:
                        // The other schemes know no corrections.
                        if constexpr (!again) other_scheme(tile, range);
                }
            });
        }
    }
    template <class Tile>
    static RECOAT_HD void other_scheme(const Tile& tile, TileRange range) {
        if (tile.w.impulse.index() == 3)
            tile.template solve<false>(*std::get_if<3>(&tile.w.impulse), range);
        else
            tile.template solve<false>(*std::get_if<4>(&tile.w.impulse), range);
    }

    template <class Function>
    static RECOAT_HD void with_partner(const Work& w, const Wall* wall, const Function& f) {
        if (wall == nullptr)
            f(PairTile<Set, Variant>{w});
        else if (wall->kind == WallKind::plane)
            f(WallTile<Set, Variant, PlaneShape>{w, PlaneShape(wall->point, wall->normal), wall->velocity});
        else
            f(WallTile<Set, Variant, BoxShape>{w, BoxShape(wall->lower, wall->upper), wall->velocity});
    }
};

template <class Set, class Variant>
TileKernels<Variant> tile_kernels() {
    using Loops = TileLoops<Set, Variant>;
    return {Loops::contacts, Loops::particles, Loops::near, Loops::foresee, Loops::correct, Loops::finish};
}

/// Instantiates the loops of every variant of numbers `Number` for the instruction set `Set`.
#define RECOAT_TILE_KERNELS_OF(equal, cohesive, relative, Number)        \
    template TileKernels<TileVariant<equal, cohesive, relative, Number>> \
    tile_kernels<RECOAT_TILE_SET, TileVariant<equal, cohesive, relative, Number>>();

}  // namespace recoat
