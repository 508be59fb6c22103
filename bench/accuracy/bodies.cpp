#include "bench/accuracy/bodies.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "solver/contact/material.hpp"

namespace recoat {

Bodies::Bodies(const Scene& scene, bool wall)
    : setup_(engine_setup(scene, Resources{.backend = Backend::cpu, .threads = 1})),
      wall_(wall),
      gravity_(scene.gravity),
      mass_(sphere_mass(0.5 * scene.diameter, scene.model.density)) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    setup_.gravity = {};
    setup_.y_period = 0;
    setup_.domain_lower = {-infinity, -infinity, -infinity};
    setup_.domain_upper = {infinity, infinity, infinity};
}

double Bodies::reduced_radius() const { return (wall_ ? 0.5 : 0.25) * setup_.diameter; }
double Bodies::reduced_mass() const { return (wall_ ? 1.0 : 0.5) * mass_; }

double Bodies::attraction() const {
    return pull_off_force(setup_.model.hamaker, reduced_radius(), setup_.model.minimum_separation);
}

double Bodies::overlap_under(double force) const {
    const double young = setup_.model.stiffness_ratio * setup_.model.youngs_modulus;
    const EffectiveModuli moduli = wall_ ? wall_moduli(young, setup_.model.poisson_ratio, setup_.model.wall_modulus)
                                         : pair_moduli(young, setup_.model.poisson_ratio);
    const double stiffness = 4.0 / 3.0 * moduli.normal * std::sqrt(reduced_radius());
    return std::cbrt(force * force / (stiffness * stiffness));
}

std::unique_ptr<Engine> Bodies::on_plane(const EngineSetup& setup, Vec3 centre, Vec3 velocity, Vec3 normal) const {
    ParticleTable sphere;
    sphere.position = {centre};
    sphere.velocity = {velocity};
    sphere.angular_velocity = {{}};
    sphere.radius = {0.5 * setup.diameter};
    Wall plane;
    plane.name = "plane";
    plane.normal = normal;
    return make_engine(setup, sphere, {plane});
}

std::unique_ptr<Engine> Bodies::approaching(double separation, double speed) const {
    const double radius = 0.5 * setup_.diameter;
    if (wall_) return on_plane(setup_, {0, 0, radius + separation}, {0, 0, -speed}, {0, 0, 1});
    ParticleTable pair;
    const double half = radius + 0.5 * separation;
    pair.position = {{-half, 0, 0}, {half, 0, 0}};
    pair.velocity = {{0.5 * speed, 0, 0}, {-0.5 * speed, 0, 0}};
    pair.angular_velocity = {{}, {}};
    pair.radius = {radius, radius};
    return make_engine(setup_, pair, {});
}

std::unique_ptr<Engine> Bodies::glancing(double separation, double normal, double tangential) const {
    return on_plane(setup_, {0, 0, 0.5 * diameter() + separation}, {tangential, 0, -normal}, {0, 0, 1});
}

std::unique_ptr<Engine> Bodies::sliding(double speed) const {
    EngineSetup setup = setup_;
    setup.gravity = {0, 0, -gravity_};
    const double load = attraction_scaling(model().stiffness_ratio) * attraction() + weight();
    return on_plane(setup, {0, 0, 0.5 * diameter() - overlap_under(load)}, {speed, 0, 0}, {0, 0, 1});
}

std::unique_ptr<Engine> Bodies::hanging() const {
    const double load = attraction_scaling(model().stiffness_ratio) * attraction();
    return on_plane(setup_, {0, 0, overlap_under(load) - 0.5 * diameter()}, {}, {0, 0, -1});
}

std::unique_ptr<Engine> Bodies::pulled(const Engine& engine, double gravity) const {
    EngineSetup setup = setup_;
    setup.gravity = {0, 0, -gravity};
    return restore_engine(setup, engine.save());
}

double Bodies::separation(const ParticleTable& now) const {
    if (wall_) return std::fabs(now.position[0].z) - now.radius[0];
    return norm(now.position[1] - now.position[0]) - now.radius[0] - now.radius[1];
}

double Bodies::rate(const ParticleTable& now) const {
    if (wall_) return now.position[0].z > 0 ? now.velocity[0].z : -now.velocity[0].z;
    const Vec3 apart = now.position[1] - now.position[0];
    return dot(apart, now.velocity[1] - now.velocity[0]) / norm(apart);
}

double Bodies::far_speed(double rate, double separation) const {
    const ContactModel& m = setup_.model;
    const double outside = m.non_contact == NonContactHamaker::original ? 1 : attraction_scaling(m.stiffness_ratio);
    const double strength = outside * attraction() * m.minimum_separation * m.minimum_separation;
    const double work = strength * std::max(0.0, 1 / separation - 1 / m.cut_off);
    return std::sqrt(std::max(0.0, rate * rate - 2 * work / reduced_mass()));
}

double Bodies::escape_speed() const {
    const ContactModel& m = setup_.model;
    const double well = attraction() * m.minimum_separation * (2 - m.minimum_separation / m.cut_off);
    return std::sqrt(2 * well / reduced_mass());
}

}  // namespace recoat
