#pragma once

#include <cstdint>

#include "solver/engine/row.hpp"

namespace recoat {

/// Particle arrays without ownership; index = place in the engine's order.
struct ParticleView {
    Row* position;          ///< centre, radius [m]
    Row* velocity;          ///< half a step behind the position; after the forces, half a step ahead [m/s]
    Row* spin;              ///< likewise [rad/s]
    Row* contact_velocity;  ///< estimate at the time of the position, which contact forces see [m/s]
    Row* contact_spin;      ///< likewise [rad/s]
    Row* acceleration;      ///< by everything but attraction [m/s2]
};

/// Particle arrays of a space; sorted in space by the pair lists, `id` tells who is who.
template <class Space>
struct ParticleArrays {
    template <class T>
    using Array = typename Space::template Array<T>;

    Array<Row> position, velocity, spin, contact_velocity, contact_spin, acceleration;
    Array<std::int64_t> id;

    [[nodiscard]] std::size_t size() const { return position.size(); }

    void resize(std::size_t n) {
        each_row([&](Array<Row>& rows) { rows.resize(n); });
        id.resize(n);
    }

    [[nodiscard]] ParticleView view() {
        return {position.data(),         velocity.data(),     spin.data(),
                contact_velocity.data(), contact_spin.data(), acceleration.data()};
    }

    /// Calls f for every per-particle array of rows, named once.
    template <class Function>
    void each_row(const Function& f) {
        for (Array<Row>* rows : {&position, &velocity, &spin, &contact_velocity, &contact_spin, &acceleration})
            f(*rows);
    }

    /// Calls f(of this, of the other) for every array that a checkpoint holds.
    template <class Other, class Function>
    void each_saved(Other& other, const Function& f) {
        f(position, other.position);
        f(velocity, other.velocity);
        f(spin, other.spin);
        f(contact_velocity, other.contact_velocity);
        f(contact_spin, other.contact_spin);
        f(acceleration, other.acceleration);
        f(id, other.id);
    }
};

}  // namespace recoat
