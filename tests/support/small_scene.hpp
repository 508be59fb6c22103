#pragma once

#include <cmath>
#include <cstdint>
#include <limits>
#include <memory>
#include <stdexcept>
#include <utility>
#include <vector>

#include "solver/contact/material.hpp"
#include "solver/engine/engine.hpp"
#include "tests/support/backend.hpp"

namespace recoat::testing {

/// The paper's powder [paper table 1; docs/physics.md section 1.1].
namespace powder {
inline constexpr double radius = 25e-6, diameter = 50e-6, density = 4430, gravity = 9.81;
inline constexpr double youngs_modulus = 110e9, poisson_ratio = 0.3, minimum_separation = 1.65e-10;
inline const double mass = sphere_mass(radius, density);
inline const double inertia = sphere_inertia(mass, radius);
inline const double weight = mass * gravity;

/// Contact model at the Bond number `bond` of a pair.
inline ContactModel model(double stiffness_ratio = 0.001, double bond = 0) {
    ContactModel model;
    model.density = density;
    model.youngs_modulus = youngs_modulus;
    model.poisson_ratio = poisson_ratio;
    model.restitution = 0.4;
    model.sliding_friction = 0.3;
    model.rolling_friction = 0.01;
    model.stiffness_ratio = stiffness_ratio;
    model.hamaker = hamaker_from_bond(bond, radius, density, gravity, minimum_separation);
    return model;
}

/// Hertz constant k of F = k d^1.5 at that ratio, for the reduced radius [N/m^1.5].
inline double hertz(double stiffness_ratio, double reduced_radius) {
    return 2.0 / 3.0 * plane_strain_modulus(stiffness_ratio * youngs_modulus, poisson_ratio) *
           std::sqrt(reduced_radius);
}
}  // namespace powder

/// A few spheres and walls, filled in by a test.
struct SmallScene {
    EngineSetup setup;
    ParticleTable particles;
    std::vector<Wall> walls;

    SmallScene(const ContactModel& model, double time_step, double diameter = powder::diameter) {
        constexpr double infinity = std::numeric_limits<double>::infinity();
        setup.model = model;
        setup.time_step = time_step;
        setup.diameter = diameter;
        setup.domain_lower = {-infinity, -infinity, -infinity};
        setup.domain_upper = {infinity, infinity, infinity};
        setup.resources = test_resources();
    }

    /// A sphere of half the diameter of the set-up, unless `radius` is given.
    void sphere(Vec3 position, Vec3 velocity = {}, Vec3 angular_velocity = {}, double radius = 0) {
        particles.position.push_back(position);
        particles.velocity.push_back(velocity);
        particles.angular_velocity.push_back(angular_velocity);
        particles.radius.push_back(radius > 0 ? radius : 0.5 * setup.diameter);
    }

    void plane(Vec3 point, Vec3 normal, Vec3 velocity = {}) {
        Wall wall;
        wall.name = "plane";
        wall.point = point;
        wall.normal = normal;
        wall.velocity = velocity;
        walls.push_back(wall);
    }

    void box(Vec3 lower, Vec3 upper, Vec3 velocity = {}) {
        Wall wall;
        wall.name = "box";
        wall.kind = WallKind::box;
        wall.lower = lower;
        wall.upper = upper;
        wall.velocity = velocity;
        walls.push_back(wall);
    }

    [[nodiscard]] std::unique_ptr<Engine> engine() const { return make_engine(setup, particles, walls); }
};

/// Two equal spheres on the x axis, `separation` apart and closing at `speed`, each with half of it.
inline SmallScene head_on_pair(const ContactModel& model, double time_step, double separation, double speed,
                               double diameter = powder::diameter) {
    SmallScene scene(model, time_step, diameter);
    scene.sphere({-0.5 * (diameter + separation), 0, 0}, {0.5 * speed, 0, 0});
    scene.sphere({0.5 * (diameter + separation), 0, 0}, {-0.5 * speed, 0, 0});
    return scene;
}

/// A sphere `separation` above the plane z = 0, with `velocity`.
inline SmallScene over_plane(const ContactModel& model, double time_step, double separation, Vec3 velocity,
                             Vec3 angular_velocity = {}, double diameter = powder::diameter) {
    SmallScene scene(model, time_step, diameter);
    scene.plane({0, 0, 0}, {0, 0, 1});
    scene.sphere({0, 0, 0.5 * diameter + separation}, velocity, angular_velocity);
    return scene;
}

/// Separation of the first two spheres [m].
inline double pair_separation(const ParticleTable& p) {
    return norm(p.position[1] - p.position[0]) - p.radius[0] - p.radius[1];
}

/// Its rate [m/s].
inline double pair_rate(const ParticleTable& p) {
    const Vec3 apart = p.position[1] - p.position[0];
    return dot(apart, p.velocity[1] - p.velocity[0]) / norm(apart);
}

/// Advances until the first sphere has met its partner and has left it again: `separation` and `rate` of a table tell.
/// Returns the table some steps later, when the forces of the contact have gone from the velocities.
template <class Separation, class Rate>
ParticleTable after_impact(Engine& engine, const Separation& separation, const Rate& rate,
                           std::int64_t most_steps = 1000000) {
    constexpr std::int64_t chunk = 8;
    for (std::int64_t step = 0; step < most_steps; step += chunk) {
        engine.advance(chunk);
        const ParticleTable now = engine.particles();
        if (separation(now) > 0 && rate(now) > 0) {
            engine.advance(chunk);
            return engine.particles();
        }
    }
    throw std::runtime_error("the spheres did not separate");
}

inline ParticleTable after_pair_impact(Engine& engine) { return after_impact(engine, pair_separation, pair_rate); }

/// Of the first sphere with the plane z = 0.
inline ParticleTable after_plane_impact(Engine& engine) {
    return after_impact(
        engine, [](const ParticleTable& p) { return p.position[0].z - p.radius[0]; },
        [](const ParticleTable& p) { return p.velocity[0].z; });
}

}  // namespace recoat::testing
