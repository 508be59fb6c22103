#include "solver/scene/time_step_limits.hpp"

#include <cmath>
#include <numbers>

#include "common/number.hpp"
#include "solver/contact/material.hpp"

namespace recoat {
namespace {

struct Pair {
    double radius, mass;  ///< R*, m*
    EffectiveModuli moduli;
};

Pair reduced_pair(const Scene& scene) {
    const ContactModel& model = scene.model;
    const double radius = 0.5 * scene.smallest_diameter;
    return {0.5 * radius, 0.5 * sphere_mass(radius, model.density),
            pair_moduli(model.youngs_modulus * model.stiffness_ratio, model.poisson_ratio)};
}

/// pi R sqrt(rho/G)/(0.1631 nu + 0.8766): travel of a surface wave around half the sphere.
double rayleigh_time(const Scene& scene) {
    const ContactModel& model = scene.model;
    const double shear = model.youngs_modulus * model.stiffness_ratio / (2 * (1 + model.poisson_ratio));
    return std::numbers::pi * 0.5 * scene.smallest_diameter * std::sqrt(model.density / shear) /
           (0.1631 * model.poisson_ratio + 0.8766);
}

StepLimit contact_limit(const Scene& scene, double speed) {
    return {"contact time at " + shortest(speed) + " m/s", "2.943 delta_max/v", contact_time(scene, speed), false};
}

}  // namespace

double largest_impact_overlap(const Scene& scene, double speed) {
    const Pair pair = reduced_pair(scene);
    return std::pow(15 * pair.mass * speed * speed / (16 * pair.moduli.normal * std::sqrt(pair.radius)), 0.4);
}

double contact_time(const Scene& scene, double speed) {
    return 2.9432751843 * largest_impact_overlap(scene, speed) / speed;
}

double attraction_crossing_time(const Scene& scene) {
    const Pair pair = reduced_pair(scene);
    const double force = pull_off_force(scene.model.hamaker, pair.radius, scene.model.minimum_separation);
    return std::sqrt(2 * pair.mass * scene.model.minimum_separation / force);
}

std::vector<StepLimit> time_step_limits(const Scene& scene) {
    const Pair pair = reduced_pair(scene);
    const double speed = scene.reference_speed;
    const double root = std::sqrt(pair.radius * largest_impact_overlap(scene, speed));
    const double normal_stiffness = 2 * pair.moduli.normal * root;
    const double tangential_stiffness = 8 * pair.moduli.shear * root;
    std::vector<StepLimit> limits = {
        {"Rayleigh time", "pi R sqrt(rho/G)/(0.1631 nu + 0.8766)", rayleigh_time(scene), false},
        contact_limit(scene, speed),
        contact_limit(scene, 10 * speed),
        {"normal contact frequency", "2/sqrt(S_n/m*)", 2 / std::sqrt(normal_stiffness / pair.mass), true},
        {"tangential contact frequency", "2/sqrt(3.5 S_t/m*)", 2 / std::sqrt(3.5 * tangential_stiffness / pair.mass),
         true}};
    if (scene.model.hamaker > 0) {
        limits.push_back(
            {"van der Waals solve", "sqrt(2 m* s_min/F_o): b F_o/s_min = 1", attraction_crossing_time(scene), false});
    }
    return limits;
}

}  // namespace recoat
