#pragma once

#include <optional>

#include "solver/contact/material.hpp"
#include "solver/scene/scene.hpp"

namespace recoat {

/// A number for two spheres and for a sphere on a wall.
struct PairAndWall {
    double pair = 0, wall = 0;
};

/// Numbers that follow from a scene, for spheres of diameter d_p. SI units.
struct DerivedNumbers {
    double mass = 0, inertia = 0, weight = 0;     ///< [kg], [kg m2], [N]
    EffectiveModuli pair_original, pair_reduced;  ///< E*, G* [Pa]
    EffectiveModuli wall_original, wall_reduced;
    double damping = 0;                                ///< beta [-]
    double hamaker_original = 0, hamaker_reduced = 0;  ///< A^O, A^R [J]
    PairAndWall bond_number;                           ///< pull-off force over weight [-]
    PairAndWall pull_off;                              ///< [N]
    double inertial_length_paper = 0;                  ///< v^2/(2 mu g d_p (1 + Bo)) [d_p]; infinite without friction
    double inertial_length_wall = 0;                   ///< the same with the pull-off force from a wall, 1 + 2 Bo [d_p]
};

/// [docs/physics.md sections 1.1, 1.7 and 5.9].
DerivedNumbers derived_numbers(const Scene& scene);

/// What a powder of unequal spheres is like. The Bond number falls as 1/d^2: weight grows as d^3, attraction as d.
struct PowderSizes {
    double smallest = 0, largest = 0;                 ///< bounds of the diameters [m]
    double mean = 0;                                  ///< over the number [m]
    double sauter = 0;                                ///< d_32, of the same surface per volume [m]
    double median_by_number = 0, median_by_mass = 0;  ///< [m]
    double bond_smallest = 0, bond_largest = 0;       ///< of pairs of such spheres [-]
};

/// Of a scene whose powder has a size distribution; nothing for others.
std::optional<PowderSizes> powder_sizes(const Scene& scene);

}  // namespace recoat
