#pragma once

#include "solver/contact/model.hpp"

namespace recoat {

/// Two spheres of unequal size, or a sphere and a wall, as a contact sees them.
struct ContactPartners {
    double reduced_radius = 0;  ///< R* [m]
    double reduced_mass = 0;    ///< m* [kg]
    bool wall = false;
};

ContactPartners pair_of(double first_radius, double second_radius, double density);
ContactPartners with_wall(double radius, double density);

/// Highest frequency w of a contact [1/s]: w^2 is the largest of S_n/m* at `overlap` [m], of 3.5 S_t/m* at the overlap
/// that the friction load there stands for, and of the steepest slope of the attraction, 2 F_o/(s_min m*)
/// [docs/physics.md sections 1.3, 1.5, 1.7 and 2.2].
double contact_frequency(const ContactModel& model, const ContactPartners& partners, double overlap);

}  // namespace recoat
