#pragma once

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <memory>
#include <ostream>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "solver/engine/engine.hpp"
#include "tests/support/backend.hpp"
#include "tests/support/paper_model.hpp"

namespace recoat::testing {

inline constexpr double dp = 2 * paper_radius;
inline constexpr double infinite = std::numeric_limits<double>::infinity();

struct EngineScene {
    EngineSetup setup;
    ParticleTable particles;
    std::vector<Wall> walls;

    [[nodiscard]] std::unique_ptr<Engine> engine() const { return make_engine(setup, particles, walls); }
};

inline Wall plane(std::string name, Vec3 point, Vec3 normal) {
    return {std::move(name), WallKind::plane, point, normal, {}, {}, {}, true};
}

inline Wall box(std::string name, Vec3 lower, Vec3 upper, Vec3 velocity = {}) {
    return {std::move(name), WallKind::box, {}, {}, lower, upper, velocity, true};
}

inline void add_particle(ParticleTable& table, Vec3 position, Vec3 velocity = {}, Vec3 spin = {},
                         double radius = paper_radius) {
    table.position.push_back(position);
    table.velocity.push_back(velocity);
    table.angular_velocity.push_back(spin);
    table.radius.push_back(radius);
}

/// Gravity down, step 1e-7 s at a stiffness ratio of 0.001, no period, a domain of 1 m each way.
inline EngineSetup paper_setup(double bond_number = 0) {
    EngineSetup setup;
    setup.model = paper_model(0.001, bond_number);
    setup.gravity = {0, 0, -paper_gravity};
    setup.time_step = 1e-7;
    setup.diameter = dp;
    setup.domain_lower = {-1, -1, -1};
    setup.domain_upper = {1, 1, 1};
    setup.resources = test_resources();
    return setup;
}

/// Spheres that do not overlap, at random places in a box (fill no more than a quarter of it, or there is no room for
/// the last); radii are between `spread` and 1 times the paper's. In y the
/// box is periodic when `period` says so.
inline ParticleTable random_packing(std::size_t count, Vec3 size, double spread, bool period, unsigned seed) {
    std::mt19937_64 random(seed);
    std::uniform_real_distribution<double> unit(0, 1);
    std::normal_distribution<double> normal;
    ParticleTable table;
    while (table.size() < count) {
        const double r = paper_radius * (spread + (1 - spread) * unit(random));
        const double y_edge = period ? 0 : r;
        const Vec3 x = {r + (size.x - 2 * r) * unit(random), y_edge + (size.y - 2 * y_edge) * unit(random),
                        r + (size.z - 2 * r) * unit(random)};
        bool free = true;
        for (std::size_t j = 0; free && j < table.size(); ++j) {
            Vec3 d = table.position[j] - x;
            if (period) d.y -= size.y * std::round(d.y / size.y);
            free = norm(d) > r + table.radius[j];
        }
        if (!free) continue;
        const Vec3 velocity = 0.1 * Vec3{normal(random), normal(random), normal(random)};
        add_particle(table, x, velocity, 4000 * Vec3{normal(random), normal(random), normal(random)}, r);
    }
    return table;
}

struct Variety {
    double bond = 0;
    RollingForm rolling = RollingForm::own;
    double spread = 1;
    std::size_t particles = 600;

    /// As it stands in the name of a test.
    friend void PrintTo(const Variety& v, std::ostream* out) {
        *out << "Bo " << v.bond << (v.rolling == RollingForm::relative ? ", relative rolling" : "")
             << (v.spread < 1 ? ", unequal" : "");
    }
};

/// Particles on a loose grid that fly about at random in a box, periodic in y, with a bar above them: collisions begin
/// within some tens of steps, everywhere and with every wall.
inline EngineScene busy_box(const Variety& variety) {
    EngineScene scene;
    scene.setup = paper_setup(variety.bond);
    scene.setup.model.rolling_form = variety.rolling;
    const double spacing = 1.01 * dp;
    const std::size_t along = 12, across = 8, high = (variety.particles + along * across - 1) / (along * across);
    scene.setup.y_min = -2 * dp;
    scene.setup.y_period = static_cast<double>(across) * spacing;
    std::mt19937_64 random(7);
    std::uniform_real_distribution<double> unit(0, 1);
    std::normal_distribution<double> normal;
    const auto at = [&](std::size_t k) { return (static_cast<double>(k) + 0.5) * spacing; };
    for (std::size_t k = 0; k < variety.particles; ++k) {
        const Vec3 x = {at(k % along), at(k / along % across), at(k / along / across)};
        const Vec3 velocity = 0.1 * Vec3{normal(random), normal(random), normal(random)};
        const Vec3 spin = 4000 * Vec3{normal(random), normal(random), normal(random)};
        add_particle(scene.particles, x, velocity, spin,
                     paper_radius * (variety.spread + (1 - variety.spread) * unit(random)));
    }
    const double end = static_cast<double>(along) * spacing, top = static_cast<double>(high) * spacing;
    scene.walls = {plane("base", {}, {0, 0, 1}), plane("left", {}, {1, 0, 0}), plane("right", {end, 0, 0}, {-1, 0, 0}),
                   box("bar", {4.9 * spacing, -infinite, top}, {7.1 * spacing, infinite, infinite})};
    return scene;
}

inline const std::vector<Variety> varieties = {{0, RollingForm::own, 1},      {50, RollingForm::own, 1},
                                               {0, RollingForm::relative, 1}, {50, RollingForm::relative, 1},
                                               {50, RollingForm::own, 0.97},  {0, RollingForm::relative, 0.97}};

inline std::string name_of(const Variety& v) {
    return "Bo " + std::to_string(v.bond) + (v.rolling == RollingForm::own ? ", own" : ", relative") +
           " rolling, radii " + std::to_string(v.spread) + " to 1";
}

/// All bits of the numbers that users see.
inline std::vector<std::uint64_t> bits_of(const Engine& engine) {
    std::vector<std::uint64_t> bits;
    const auto add = [&](double v) { bits.push_back(std::bit_cast<std::uint64_t>(v)); };
    const auto add3 = [&](Vec3 v) {
        add(v.x);
        add(v.y);
        add(v.z);
    };
    const ParticleTable table = engine.particles();
    for (std::size_t i = 0; i < table.size(); ++i) {
        add3(table.position[i]);
        add3(table.velocity[i]);
        add3(table.angular_velocity[i]);
        add(table.radius[i]);
    }
    for (const ContactState& contact : engine.contacts()) {
        bits.push_back(static_cast<std::uint64_t>(contact.first));
        bits.push_back(static_cast<std::uint64_t>(contact.second));
        add3(contact.normal);
        add(contact.separation);
        add(contact.normal_force);
        add3(contact.tangential_force);
    }
    const EnergyLedger e = engine.ledger();
    for (const double v : {e.kinetic_translation, e.kinetic_rotation, e.elastic_normal, e.elastic_tangential, e.gravity,
                           e.cohesion, e.dissipated_normal, e.dissipated_tangential, e.dissipated_rolling, e.wall_work,
                           e.removed_with_walls, engine.kinetic_energy(), engine.largest_overlap()})
        add(v);
    return bits;
}

/// Energy that must stay the same: stored, lost, and exchanged with walls [J].
inline double balance(const EnergyLedger& e) {
    return e.stored() + e.dissipated() - e.wall_work + e.removed_with_walls;
}

}  // namespace recoat::testing
