#pragma once

#include <cmath>
#include <numbers>

#include "common/host_device.hpp"
#include "solver/contact/material.hpp"

namespace recoat {

/// Numbers of one contact that do not change while it lasts.
struct Coefficients {
    double hertz;                ///< k_H = 4/3 E* sqrt(R*) [N/m^1.5]
    double normal_damping;       ///< sqrt(5) beta sqrt(m* k_H): times overlap^(1/4) it is c_n [kg/s/m^0.25]
    double tangential_damping;   ///< 2 sqrt(5/6) beta_t sqrt(8 G* sqrt(R*) m*), likewise
    double inverse_mass;         ///< 1/m* [1/kg]
    double attraction_gap;       ///< F_o: largest attraction out of contact [N]
    double attraction_contact;   ///< F_r: attraction in contact [N]
    double attraction_friction;  ///< F_v^O of eq. 8 (original Hamaker constant) [N]
    double rolling_length;       ///< length that the contact gives to rolling resistance [m]; 1 where the particle does
};

/// Numbers of one kind of contact (pair or wall), before radii and masses are known.
struct ContactScale {
    double modulus = 0, shear_modulus = 0;  ///< E*, G* of the reduced stiffness [Pa]
    double normal_damping = 0;              ///< sqrt(5) beta [-]
    double tangential_damping = 0;          ///< 2 sqrt(5/6) beta_t [-]
    double attraction_gap = 0, attraction_contact = 0, attraction_friction = 0;  ///< A/(6 s_min^2) [N/m]
    double rolling_factor = 0, rolling_constant = 1;  ///< rolling length = factor R* + constant

    RECOAT_HD Coefficients at(double reduced_radius, double reduced_mass) const {
        const double root = std::sqrt(reduced_radius);
        const double hertz = 4.0 / 3.0 * modulus * root;
        return {hertz,
                normal_damping * std::sqrt(reduced_mass * hertz),
                tangential_damping * std::sqrt(8 * shear_modulus * root * reduced_mass),
                1 / reduced_mass,
                attraction_gap * reduced_radius,
                attraction_contact * reduced_radius,
                attraction_friction * reduced_radius,
                rolling_factor * reduced_radius + rolling_constant};
    }
};

/// The scales of `model` for pairs (`wall` = false) or walls.
inline ContactScale contact_scale(const ContactModel& model, bool wall) {
    const double modulus = model.youngs_modulus * model.stiffness_ratio;
    const EffectiveModuli moduli = wall ? wall_moduli(modulus, model.poisson_ratio, model.wall_modulus)
                                        : pair_moduli(modulus, model.poisson_ratio);
    const double beta = damping_coefficient(model.restitution);
    const double original = model.hamaker / (6 * model.minimum_separation * model.minimum_separation);
    const double reduced = attraction_scaling(model.stiffness_ratio) * original;
    ContactScale scale;
    scale.modulus = moduli.normal;
    scale.shear_modulus = moduli.shear;
    scale.normal_damping = std::sqrt(5.0) * beta;
    scale.tangential_damping =
        model.tangential_damping == TangentialDamping::none ? 0 : 2 * std::sqrt(5.0 / 6.0) * beta;
    scale.attraction_gap = model.non_contact == NonContactHamaker::original ? original : reduced;
    scale.attraction_contact = reduced;
    scale.attraction_friction = original;
    if (model.rolling_length == RollingLength::reduced_radius) {
        scale.rolling_factor = 1;
        scale.rolling_constant = 0;
    } else if (model.rolling_form == RollingForm::relative) {
        // Equal and opposite torques need one length per contact: the harmonic mean of the radii, 2R*, or R at a wall.
        const double length = wall ? 1 : 2;
        scale.rolling_factor = model.rolling_length == RollingLength::diameter ? 2 * length : length;
        scale.rolling_constant = 0;
    }
    return scale;
}

/// Coefficients when all particles are alike: two constants.
struct EqualSizes {
    static constexpr bool equal = true;
    Coefficients pair, wall;
    double radius, mass, inertia, inverse_mass, inverse_inertia;

    RECOAT_HD const Coefficients& of_pair(double, double) const { return pair; }
    RECOAT_HD const Coefficients& of_wall(double) const { return wall; }
    RECOAT_HD double mass_of(double) const { return mass; }
    RECOAT_HD double inertia_of(double) const { return inertia; }
    RECOAT_HD double inverse_mass_of(double) const { return inverse_mass; }
    RECOAT_HD double inverse_inertia_of(double) const { return inverse_inertia; }
    RECOAT_HD double radius_of(double) const { return radius; }
};

/// Coefficients of spheres of any radii.
struct AnySizes {
    static constexpr bool equal = false;
    ContactScale pair, wall;
    double density;

    RECOAT_HD double mass_of(double r) const { return 4.0 / 3.0 * std::numbers::pi * r * r * r * density; }
    RECOAT_HD double inertia_of(double r) const { return 0.4 * mass_of(r) * r * r; }
    RECOAT_HD double inverse_mass_of(double r) const { return 1 / mass_of(r); }
    RECOAT_HD double inverse_inertia_of(double r) const { return 1 / inertia_of(r); }
    RECOAT_HD double radius_of(double r) const { return r; }
    RECOAT_HD Coefficients of_pair(double r, double q) const {
        const double m = mass_of(r), n = mass_of(q);
        return pair.at(r * q / (r + q), m * n / (m + n));
    }
    RECOAT_HD Coefficients of_wall(double r) const { return wall.at(r, mass_of(r)); }
};

inline EqualSizes equal_sizes(const ContactModel& model, double radius) {
    const double mass = sphere_mass(radius, model.density);
    return {contact_scale(model, false).at(0.5 * radius, 0.5 * mass),
            contact_scale(model, true).at(radius, mass),
            radius,
            mass,
            sphere_inertia(mass, radius),
            1 / mass,
            1 / sphere_inertia(mass, radius)};
}

inline AnySizes any_sizes(const ContactModel& model) {
    return {contact_scale(model, false), contact_scale(model, true), model.density};
}

}  // namespace recoat
