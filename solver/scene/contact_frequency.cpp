#include "solver/scene/contact_frequency.hpp"

#include <algorithm>
#include <cmath>

#include "solver/contact/coefficients.hpp"

namespace recoat {

ContactPartners pair_of(double first_radius, double second_radius, double density) {
    const double m = sphere_mass(first_radius, density), n = sphere_mass(second_radius, density);
    return {first_radius * second_radius / (first_radius + second_radius), m * n / (m + n), false};
}

ContactPartners with_wall(double radius, double density) { return {radius, sphere_mass(radius, density), true}; }

double contact_frequency(const ContactModel& model, const ContactPartners& partners, double overlap) {
    const ContactScale scale = contact_scale(model, partners.wall);
    const double root = std::sqrt(partners.reduced_radius);
    const double normal = 2 * scale.modulus * root * std::sqrt(overlap);
    const double attraction = scale.attraction_friction * partners.reduced_radius;
    const double load = std::pow(overlap, 1.5) + attraction / (4.0 / 3.0 * scale.modulus * root);  // over k_H
    const double tangential = 8 * scale.shear_modulus * root * std::cbrt(load);
    const double slope = 2 * attraction / model.minimum_separation;
    const double friction = model.sliding_friction > 0 ? 3.5 * tangential : 0;
    return std::sqrt(std::max({normal, friction, slope}) / partners.reduced_mass);
}

}  // namespace recoat
