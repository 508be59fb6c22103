#pragma once

#include <cstdint>
#include <vector>

#include "common/vec3.hpp"

namespace recoat {

/// Four doubles that are loaded together.
struct Row {
    double x = 0, y = 0, z = 0, w = 0;

    RECOAT_HD Vec3 xyz() const { return {x, y, z}; }
    RECOAT_HD void set(Vec3 v) {
        x = v.x;
        y = v.y;
        z = v.z;
    }
};

/// Particle arrays without ownership; index = place in the engine's order.
struct ParticleView {
    Row* position;          ///< centre, radius [m]
    Row* velocity;          ///< half a step behind the position; after the forces, half a step ahead [m/s]
    Row* spin;              ///< likewise [rad/s]
    Row* contact_velocity;  ///< estimate at the time of the position, which contact forces see [m/s]
    Row* contact_spin;      ///< likewise [rad/s]
    Row* acceleration;      ///< by everything but attraction [m/s2]
};

/// Particle arrays; sorted in space by the pair lists, `id` tells who is who.
struct Particles {
    std::vector<Row> position, velocity, spin, contact_velocity, contact_spin, acceleration;
    std::vector<std::int64_t> id;

    [[nodiscard]] std::size_t size() const { return position.size(); }

    void resize(std::size_t n) {
        for (auto* rows : all()) rows->resize(n);
        id.resize(n);
    }

    [[nodiscard]] ParticleView view() {
        return {position.data(),         velocity.data(),     spin.data(),
                contact_velocity.data(), contact_spin.data(), acceleration.data()};
    }

    /// Every per-particle array of rows, named once.
    std::vector<std::vector<Row>*> all() {
        return {&position, &velocity, &spin, &contact_velocity, &contact_spin, &acceleration};
    }
};

}  // namespace recoat
