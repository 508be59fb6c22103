#pragma once

#include <cstdint>
#include <type_traits>

#include "solver/contact/law.hpp"
#include "solver/engine/contacts.hpp"
#include "solver/engine/impulse_choice.hpp"
#include "solver/engine/particles.hpp"
#include "solver/engine/wall.hpp"

namespace recoat {

/// What the loops of a processor's step are compiled for: nothing is asked inside them.
template <bool equal_sizes, bool is_cohesive, bool relative, class Number>
struct TileVariant {
    static constexpr bool equal = equal_sizes, cohesive = is_cohesive, relative_rolling = relative;
    /// Law, history and forces of contacts are in single precision; positions, velocities and sums never are.
    static constexpr bool single = std::is_same_v<Number, float>;
    using Real = Number;
    using Sizes = std::conditional_t<equal, EqualSizesOf<Real>, AnySizesOf<Real>>;
};

/// Rows of four doubles in which a particle's contacts are added up: force and load, torque and number of contacts
/// whose attraction needs a solve, then, where the scene has them, the attraction of the others and relative rolling.
template <class Variant>
struct SumLayout {
    static constexpr int attraction = 8;
    static constexpr int rolling = Variant::cohesive ? 12 : 8;
    static constexpr int size = 8 + (Variant::cohesive ? 4 : 0) + (Variant::relative_rolling ? 4 : 0);
};

/// A stretch of places.
struct TileRange {
    std::size_t begin = 0, end = 0;
};

/// Contacts whose attraction has to be solved for, with what the solve needs, at the places of a stretch of contacts.
template <class Real>
struct NearContacts {
    std::int32_t* contact;
    Real *normal_x, *normal_y, *normal_z, *separation;
};

/// Everything that the loops read and write. One struct for all of them: which of it is used follows from the variant.
template <class Variant>
struct TileWork {
    using Real = typename Variant::Real;

    typename Variant::Sizes sizes;
    ContactLaw<Variant::cohesive, Real> law;
    AttractionOf<Real> attraction;
    ImpulseChoiceOf<Real> impulse;
    Vec3 gravity;
    double y_period, inverse_period;
    double time_step;
    bool radius_arm;              ///< arms of friction are radii, not those to the contact point
    double own_rolling_length;    ///< times the radius, plus ...
    double own_rolling_constant;  ///< ... this, multiplies the load [-]

    double *position, *velocity, *spin, *acceleration, *contact_velocity, *contact_spin;  ///< rows of four
    float* motion;         ///< single precision: rows of contact velocity and contact spin, four numbers each
    double* lost_rolling;  ///< a tile books at its first place
    double* sums;          ///< SumLayout::size doubles a particle
    const std::int32_t *first, *second;
    const std::int32_t* second_sums;  ///< [pairs] place of `sums` for the second: TilePlan
    Real *slip_x, *slip_y, *slip_z, *last_attraction;
    double *lost_normal, *lost_tangential, *wall_work;  ///< a stretch of contacts books at its first place
    NearContacts<Real> near;
    std::int32_t* near_particles;       ///< those of near contacts, part by part
    const std::int32_t* contact_count;  ///< [N] listed contacts of each particle, for relative rolling
};

/// What a loop found.
struct TileTally {
    double largest_overlap = 0;  ///< [m]
    double largest_square = 0;   ///< squared speed; infinity when one is not finite
    std::size_t near = 0;        ///< contacts whose attraction has to be solved for
    std::size_t near_particles = 0;
};

/// The loops for one instruction set. `wall` is null for pairs.
template <class Variant>
struct TileKernels {
    using Work = TileWork<Variant>;

    /// Forces of the contacts of `range`; near contacts are listed from place `range.begin` + tally.near on.
    void (*contacts)(const Work&, const Wall* wall, TileRange range, std::size_t near_begin, TileTally&);
    /// Velocities of the particles of `range`, and positions of those without near contacts; the others are listed from
    /// place `near_begin` of near_particles on.
    void (*particles)(const Work&, TileRange range, std::size_t near_begin, TileTally&);
    /// Attraction of the listed near contacts.
    void (*near)(const Work&, const Wall* wall, TileRange range);
    /// Mean velocities of the step of the particles listed in `range`, by the impulses found so far.
    void (*foresee)(const Work&, TileRange range);
    /// Attraction of the near contacts again, from those.
    void (*correct)(const Work&, const Wall* wall, TileRange range);
    /// Positions of the particles listed in `range`.
    void (*finish)(const Work&, TileRange range, TileTally&);
};

/// Those of `set`, one function a translation unit (tile_kernels_*.cpp).
template <class Set, class Variant>
TileKernels<Variant> tile_kernels();

/// Every combination that there is; a translation unit instantiates its kernels for them.
#define RECOAT_FOR_EACH_TILE_VARIANT(f, number)                                                  \
    f(true, true, true, number) f(true, true, false, number) f(true, false, true, number)        \
        f(true, false, false, number) f(false, true, true, number) f(false, true, false, number) \
            f(false, false, true, number) f(false, false, false, number)

}  // namespace recoat
