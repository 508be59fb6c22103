#pragma once

#include <cstdint>
#include <limits>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "common/vec3.hpp"
#include "solver/contact/model.hpp"
#include "solver/engine/list_skins.hpp"
#include "solver/engine/wall.hpp"
#include "solver/execution/resources.hpp"

namespace recoat {

/// Particles as the host sees them; the index is the identity for the whole run.
struct ParticleTable {
    std::vector<Vec3> position;          ///< [N] centres [m]
    std::vector<Vec3> velocity;          ///< [N] at the time of the positions [m/s]
    std::vector<Vec3> angular_velocity;  ///< [N] [rad/s]
    std::vector<double> radius;          ///< [N] [m]

    [[nodiscard]] std::size_t size() const { return position.size(); }
};

/// In what precision contacts are computed; positions, velocities and sums are always in double precision.
enum class Precision {
    double_precision,
    mixed  ///< law, history and forces of contacts in single precision
};

/// What an engine is built from.
struct EngineSetup {
    ContactModel model;
    Vec3 gravity;          ///< [m/s2]
    double time_step = 0;  ///< [s]
    double diameter = 0;   ///< d_p [m]; sets the skins of the pair lists
    double y_min = 0;      ///< [m]
    double y_period = 0;   ///< [m]; 0: not periodic
    Vec3 domain_lower;     ///< a centre outside the domain is a fault; entries may be infinite [m]
    Vec3 domain_upper;
    ListSkins skins;
    Precision precision = Precision::double_precision;
    bool sleep = false;  ///< particles at rest are left as they are [docs/decisions/0011-sleep.md]
    Resources resources;
};

/// Energies of particles and walls [J].
struct EnergyLedger {
    // stored now
    double kinetic_translation = 0, kinetic_rotation = 0, elastic_normal = 0, elastic_tangential = 0, gravity = 0,
           cohesion = 0;
    // lost since the start
    double dissipated_normal = 0, dissipated_tangential = 0, dissipated_rolling = 0;
    // work of moving walls on the particles since the start, and energy that removed walls took with them
    double wall_work = 0, removed_with_walls = 0;

    [[nodiscard]] double stored() const {
        return kinetic_translation + kinetic_rotation + elastic_normal + elastic_tangential + gravity + cohesion;
    }
    [[nodiscard]] double dissipated() const { return dissipated_normal + dissipated_tangential + dissipated_rolling; }
};

/// One pair, or particle and wall, within the cut-off of the attraction.
struct ContactState {
    std::int64_t first = 0;
    std::int64_t second = 0;  ///< particle index, or -1 - index of the wall
    Vec3 normal;              ///< from first to second
    double separation = 0;    ///< s < 0: overlap [m]
    double normal_force = 0;  ///< repulsion (positive) of the contact, without attraction [N]
    Vec3 tangential_force;    ///< on first [N]
};

/// When particles count as at rest: all together, but for those that are left out, have less kinetic energy than this.
struct RestLimit {
    double kinetic_energy = 0;   ///< [J]
    std::size_t stragglers = 0;  ///< so many, those that hold most, are left out, ...
    double front =
        std::numeric_limits<double>::infinity();  ///< ... as is who is beyond this x and moves on along x [m]
};

/// Named flat arrays: everything needed to continue to the bit.
struct EngineState {
    std::map<std::string, std::vector<double>> reals;
    std::map<std::string, std::vector<std::int64_t>> integers;
};

/// Moves particles under contact forces, attraction and gravity.
class Engine {
public:
    Engine() = default;
    Engine(const Engine&) = delete;
    Engine& operator=(const Engine&) = delete;
    virtual ~Engine() = default;

    /// Makes `steps` steps. Throws SimulationFault with a sentence that names particle, partner, step and cause; the
    /// particles are then those of the moment before the faulty step.
    virtual void advance(std::int64_t steps) = 0;

    [[nodiscard]] virtual std::int64_t step() const = 0;
    [[nodiscard]] virtual double time() const = 0;                         ///< [s]
    [[nodiscard]] virtual ParticleTable particles() const = 0;             ///< in order of identity, y wrapped
    [[nodiscard]] virtual std::vector<ContactState> contacts() const = 0;  ///< ordered by (first, second)
    [[nodiscard]] virtual EnergyLedger ledger() const = 0;
    [[nodiscard]] virtual double kinetic_energy() const = 0;  ///< translation and rotation [J]
    [[nodiscard]] virtual bool at_rest(const RestLimit& limit) const = 0;
    [[nodiscard]] virtual double largest_overlap() const = 0;  ///< since the start, in diameters d_p

    [[nodiscard]] virtual const std::vector<Wall>& walls() const = 0;
    virtual void set_wall_velocity(std::size_t wall, Vec3 velocity) = 0;
    virtual void remove_wall(std::size_t wall) = 0;

    [[nodiscard]] virtual EngineState save() const = 0;
};

/// Throws InputError when a particle or wall is unusable (not finite, radius <= 0, outside the domain).
std::unique_ptr<Engine> make_engine(const EngineSetup& setup, const ParticleTable& particles, std::vector<Wall> walls);

/// Continues from `state` of an engine with the same setup; threads and backend may differ.
std::unique_ptr<Engine> restore_engine(const EngineSetup& setup, const EngineState& state);

}  // namespace recoat
