#include "solver/scene/derived.hpp"

namespace recoat {

DerivedNumbers derived_numbers(const Scene& scene) {
    const ContactModel& model = scene.model;
    const double radius = 0.5 * scene.diameter;
    const double reduced = model.youngs_modulus * model.stiffness_ratio;
    DerivedNumbers numbers;
    numbers.mass = sphere_mass(radius, model.density);
    numbers.inertia = sphere_inertia(numbers.mass, radius);
    numbers.weight = numbers.mass * scene.reference_gravity;
    numbers.pair_original = pair_moduli(model.youngs_modulus, model.poisson_ratio);
    numbers.pair_reduced = pair_moduli(reduced, model.poisson_ratio);
    numbers.wall_original = wall_moduli(model.youngs_modulus, model.poisson_ratio, model.wall_modulus);
    numbers.wall_reduced = wall_moduli(reduced, model.poisson_ratio, model.wall_modulus);
    numbers.damping = damping_coefficient(model.restitution);
    numbers.hamaker_original = model.hamaker;
    numbers.hamaker_reduced = attraction_scaling(model.stiffness_ratio) * model.hamaker;
    numbers.pull_off = {pull_off_force(model.hamaker, 0.5 * radius, model.minimum_separation),
                        pull_off_force(model.hamaker, radius, model.minimum_separation)};
    numbers.bond_number = {numbers.pull_off.pair / numbers.weight, numbers.pull_off.wall / numbers.weight};
    const double speed = scene.reference_speed;
    const double free_length = speed * speed / (2 * model.sliding_friction * scene.reference_gravity * scene.diameter);
    numbers.inertial_length_paper = free_length / (1 + numbers.bond_number.pair);
    numbers.inertial_length_wall = free_length / (1 + numbers.bond_number.wall);
    return numbers;
}

std::optional<PowderSizes> powder_sizes(const Scene& scene) {
    const auto* column = std::get_if<ColumnSource>(&scene.source);
    if (!column || !column->sizes) return {};
    const SizeDistribution& sizes = *column->sizes;
    const auto bond = [&](double diameter) {
        return bond_from_hamaker(scene.model.hamaker, 0.5 * diameter, scene.model.density, scene.reference_gravity,
                                 scene.model.minimum_separation);
    };
    return PowderSizes{sizes.smallest(),       sizes.largest(),
                       sizes.moment(1),        sizes.moment(3) / sizes.moment(2),
                       sizes.diameter(0.5),    sizes.diameter_by_mass(0.5),
                       bond(sizes.smallest()), bond(sizes.largest())};
}

}  // namespace recoat
