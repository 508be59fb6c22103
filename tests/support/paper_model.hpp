#pragma once

#include "solver/contact/material.hpp"
#include "solver/contact/model.hpp"

namespace recoat::testing {

inline constexpr double paper_radius = 25e-6;  ///< [m]
inline constexpr double paper_gravity = 9.81;  ///< [m/s2]

/// The powder of the paper's Table 1 at a stiffness ratio and a Bond number.
inline ContactModel paper_model(double stiffness_ratio, double bond_number) {
    ContactModel model;
    model.density = 4430;
    model.youngs_modulus = 110e9;
    model.poisson_ratio = 0.3;
    model.restitution = 0.4;
    model.sliding_friction = 0.3;
    model.rolling_friction = 0.01;
    model.stiffness_ratio = stiffness_ratio;
    model.hamaker =
        hamaker_from_bond(bond_number, paper_radius, model.density, paper_gravity, model.minimum_separation);
    return model;
}

}  // namespace recoat::testing
