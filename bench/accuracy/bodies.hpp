#pragma once

#include <memory>

#include "solver/engine/engine.hpp"
#include "solver/scene/scene.hpp"

namespace recoat {

/// Two spheres that meet head on, or one sphere and the plane z = 0: the model of a scene with nothing else in it.
class Bodies {
public:
    Bodies(const Scene& scene, bool wall);

    /// `separation` apart and closing at `speed` [m, m/s].
    [[nodiscard]] std::unique_ptr<Engine> approaching(double separation, double speed) const;
    /// A sphere `separation` above the wall that approaches it at `normal` and goes along it at `tangential`.
    [[nodiscard]] std::unique_ptr<Engine> glancing(double separation, double normal, double tangential) const;
    /// A sphere on the wall, pressed by its weight and the attraction, that slides at `speed`.
    [[nodiscard]] std::unique_ptr<Engine> sliding(double speed) const;
    /// A sphere held by the wall above it, without gravity; `pulled` continues it under another gravity, along -z.
    [[nodiscard]] std::unique_ptr<Engine> hanging() const;
    [[nodiscard]] std::unique_ptr<Engine> pulled(const Engine& engine, double gravity) const;

    /// Surface separation [m] and its rate [m/s].
    [[nodiscard]] double separation(const ParticleTable& now) const;
    [[nodiscard]] double rate(const ParticleTable& now) const;

    /// Speed far away of bodies that part at `rate` when `separation` apart: the rest of the attraction's work is
    /// taken off [docs/physics.md section 2.4].
    [[nodiscard]] double far_speed(double rate, double separation) const;
    /// Speed that just leads out of the attraction from touch [m/s].
    [[nodiscard]] double escape_speed() const;

    [[nodiscard]] const ContactModel& model() const { return setup_.model; }
    [[nodiscard]] double time_step() const { return setup_.time_step; }
    [[nodiscard]] double diameter() const { return setup_.diameter; }
    [[nodiscard]] double weight() const { return mass_ * gravity_; }
    [[nodiscard]] double gravity() const { return gravity_; }
    /// F_o, the largest attraction out of contact [N].
    [[nodiscard]] double attraction() const;

private:
    [[nodiscard]] double reduced_radius() const;
    [[nodiscard]] double reduced_mass() const;
    /// Overlap [m] at which the contact bears `force` [N].
    [[nodiscard]] double overlap_under(double force) const;
    [[nodiscard]] std::unique_ptr<Engine> on_plane(const EngineSetup& setup, Vec3 centre, Vec3 velocity,
                                                   Vec3 normal) const;

    EngineSetup setup_;
    bool wall_;
    double gravity_, mass_;
};

}  // namespace recoat
