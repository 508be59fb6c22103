#pragma once

#include <cmath>
#include <numbers>

#include "common/host_device.hpp"
#include "solver/contact/material.hpp"

namespace recoat {

/// Numbers of one contact, or packs of those of several, that do not change while it lasts.
template <class T>
struct CoefficientsOf {
    T hertz;                ///< k_H = 4/3 E* sqrt(R*) [N/m^1.5]
    T inverse_hertz;        ///< 1/k_H
    T normal_damping;       ///< sqrt(5) beta sqrt(m* k_H): times overlap^(1/4) it is c_n [kg/s/m^0.25]
    T tangential_damping;   ///< 2 sqrt(5/6) beta_t sqrt(8 G* sqrt(R*) m*), likewise
    T inverse_mass;         ///< 1/m* [1/kg]
    T attraction_gap;       ///< F_o: largest attraction out of contact [N]
    T attraction_contact;   ///< F_r: attraction in contact [N]
    T attraction_friction;  ///< F_v^O of eq. 8 (original Hamaker constant) [N]
    T rolling_length;       ///< length that the contact gives to rolling resistance [m]; 1 where the particle does
};

using Coefficients = CoefficientsOf<double>;

/// Numbers of one kind of contact (pair or wall), before radii and masses are known.
template <class Real>
struct ContactScaleOf {
    Real modulus = 0, shear_modulus = 0;                                       ///< E*, G* of the reduced stiffness [Pa]
    Real normal_damping = 0;                                                   ///< sqrt(5) beta [-]
    Real tangential_damping = 0;                                               ///< 2 sqrt(5/6) beta_t [-]
    Real attraction_gap = 0, attraction_contact = 0, attraction_friction = 0;  ///< A/(6 s_min^2) [N/m]
    Real rolling_factor = 0, rolling_constant = 1;  ///< rolling length = factor R* + constant

    template <class T>
    RECOAT_HD CoefficientsOf<T> at(T reduced_radius, T reduced_mass) const {
        using std::sqrt;
        const T root = sqrt(reduced_radius);
        const T hertz = Real(4.0 / 3.0) * modulus * root;
        return {hertz,
                T(1) / hertz,
                normal_damping * sqrt(reduced_mass * hertz),
                tangential_damping * sqrt(Real(8) * shear_modulus * root * reduced_mass),
                T(1) / reduced_mass,
                attraction_gap * reduced_radius,
                attraction_contact * reduced_radius,
                attraction_friction * reduced_radius,
                rolling_factor * reduced_radius + T(rolling_constant)};
    }
};

using ContactScale = ContactScaleOf<double>;

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
template <class Real>
struct EqualSizesOf {
    static constexpr bool equal = true;
    CoefficientsOf<Real> pair, wall;
    double radius, mass, inertia, inverse_mass, inverse_inertia;

    template <class T>
    RECOAT_HD const CoefficientsOf<Real>& of_pair(T, T) const {
        return pair;
    }
    template <class T>
    RECOAT_HD const CoefficientsOf<Real>& of_wall(T) const {
        return wall;
    }
    RECOAT_HD double mass_of(double) const { return mass; }
    RECOAT_HD double inertia_of(double) const { return inertia; }
    RECOAT_HD double inverse_mass_of(double) const { return inverse_mass; }
    RECOAT_HD double inverse_inertia_of(double) const { return inverse_inertia; }
    template <class T>
    RECOAT_HD T radius_of(T) const {
        return T(radius);
    }
};

using EqualSizes = EqualSizesOf<double>;

/// Coefficients of spheres of any radii.
template <class Real>
struct AnySizesOf {
    static constexpr bool equal = false;
    ContactScaleOf<Real> pair, wall;
    double density;

    template <class T>
    RECOAT_HD T mass_of(T r) const {
        return Real(4.0 / 3.0 * std::numbers::pi) * r * r * r * Real(density);
    }
    RECOAT_HD double inertia_of(double r) const { return 0.4 * mass_of(r) * r * r; }
    RECOAT_HD double inverse_mass_of(double r) const { return 1 / mass_of(r); }
    RECOAT_HD double inverse_inertia_of(double r) const { return 1 / inertia_of(r); }
    template <class T>
    RECOAT_HD T radius_of(T r) const {
        return r;
    }
    template <class T>
    RECOAT_HD CoefficientsOf<T> of_pair(T r, T q) const {
        const T m = mass_of(r), n = mass_of(q);
        return pair.at(r * q / (r + q), m * n / (m + n));
    }
    template <class T>
    RECOAT_HD CoefficientsOf<T> of_wall(T r) const {
        return wall.at(r, mass_of(r));
    }
};

using AnySizes = AnySizesOf<double>;

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
