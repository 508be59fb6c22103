#pragma once

#include <cmath>
#include <numbers>

#include "solver/contact/model.hpp"

namespace recoat {

/// Mass of a solid sphere [kg] from its radius [m] and density [kg/m3].
inline double sphere_mass(double radius, double density) {
    return 4.0 / 3.0 * std::numbers::pi * radius * radius * radius * density;
}

/// Moment of inertia of a solid sphere [kg m2].
inline double sphere_inertia(double mass, double radius) { return 0.4 * mass * radius * radius; }

/// E_i = Y/(1-nu^2) [Pa]. The paper prints 1+nu^2; with 1-nu^2 the tangential law is Mindlin's
/// [docs/physics.md section 1.3].
inline double plane_strain_modulus(double youngs_modulus, double poisson_ratio) {
    return youngs_modulus / (1 - poisson_ratio * poisson_ratio);
}

/// G_i = Y/(2(2-nu)(1+nu)) [Pa]: the shear modulus over 2-nu, as Mindlin's stiffness needs it
/// [docs/physics.md section 1.5].
inline double mindlin_shear_modulus(double youngs_modulus, double poisson_ratio) {
    return youngs_modulus / (2 * (2 - poisson_ratio) * (1 + poisson_ratio));
}

/// E* and G* of one kind of contact [Pa].
struct EffectiveModuli {
    double normal = 0, shear = 0;
};

/// Two particles of the same material: half of each one's own modulus.
inline EffectiveModuli pair_moduli(double youngs_modulus, double poisson_ratio) {
    return {0.5 * plane_strain_modulus(youngs_modulus, poisson_ratio),
            0.5 * mindlin_shear_modulus(youngs_modulus, poisson_ratio)};
}

/// Particle on a wall of the same material, or on a rigid one [docs/physics.md section 1.3].
inline EffectiveModuli wall_moduli(double youngs_modulus, double poisson_ratio, WallModulus wall) {
    const EffectiveModuli pair = pair_moduli(youngs_modulus, poisson_ratio);
    return wall == WallModulus::elastic ? pair : EffectiveModuli{2 * pair.normal, 2 * pair.shear};
}

/// beta = -ln e / sqrt(ln^2 e + pi^2) [-]; exact for Hertz with the dashpot of eq. 4 when the contact force may
/// become attractive [docs/physics.md section 1.4; Antypov & Elliott, EPL 94 (2011) 50004].
inline double damping_coefficient(double restitution) {
    const double logarithm = std::log(restitution);
    return -logarithm / std::sqrt(logarithm * logarithm + std::numbers::pi * std::numbers::pi);
}

/// A^R/A^O = (Y^R/Y^O)^(2/5) [paper eq. 7].
inline double attraction_scaling(double stiffness_ratio) { return std::pow(stiffness_ratio, 0.4); }

/// A = Bo 16 pi R^2 rho g s_min^2 [J]: the pull-off force of a pair is Bo times its weight [paper eq. 10].
inline double hamaker_from_bond(double bond_number, double radius, double density, double gravity,
                                double minimum_separation) {
    return bond_number * 16 * std::numbers::pi * radius * radius * density * gravity * minimum_separation *
           minimum_separation;
}

/// Bo of a pair of equal spheres [paper eq. 10].
inline double bond_from_hamaker(double hamaker, double radius, double density, double gravity,
                                double minimum_separation) {
    return hamaker / hamaker_from_bond(1, radius, density, gravity, minimum_separation);
}

/// F = A R*/(6 s_min^2) [N]: largest attraction [paper eq. 6]. R* = R/2 for a pair, R for a wall.
inline double pull_off_force(double hamaker, double reduced_radius, double minimum_separation) {
    return hamaker * reduced_radius / (6 * minimum_separation * minimum_separation);
}

}  // namespace recoat
