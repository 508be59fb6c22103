#pragma once

#include <vector>

#include "solver/engine/contacts.hpp"
#include "solver/engine/engine.hpp"
#include "solver/engine/moving_walls.hpp"
#include "solver/engine/particles.hpp"
#include "solver/engine/totals.hpp"

namespace recoat {

/// Everything that changes while an engine runs. Saved whole, a restored engine continues to the bit: the order of the
/// particles and the age of the pair lists are part of it, because sums run in their order.
struct Snapshot {
    std::int64_t step = 0;
    bool fresh = true;  ///< not yet started: no lists, velocities at the time of the positions
    Particles particles;
    MovingWalls walls;
    Contacts contacts;
    std::vector<Row> far_reference;    ///< positions when the far list was made
    std::vector<double> lost_rolling;  ///< [N] energy taken by own-spin rolling resistance since the list was made [J]
    Totals totals;
    double margin = 0;           ///< the close list holds until particles have come closer by this [m]
    double travelled = 0;        ///< bound of any particle's or wall's way since then [m]
    double last_travel = 0;      ///< the same for the last step [m]
    double largest_overlap = 0;  ///< [m]

    Snapshot() = default;
    Snapshot(const ParticleTable& table, std::vector<Wall> walls);
    explicit Snapshot(const EngineState& state);

    [[nodiscard]] EngineState save() const;
};

double smallest_radius(const Particles& particles);
bool equal_radii(const Particles& particles);
double largest_displacement(const std::vector<Row>& now, const std::vector<Row>& before);

/// Brings y into [y_min, y_min + period).
void fold(Particles& particles, double y_min, double period);
double folded(double y, double y_min, double period);

/// Reorders every array; `order`: new place -> old place.
void permute(Particles& particles, const std::vector<std::int32_t>& order);
std::vector<std::int32_t> inverse(const std::vector<std::int32_t>& order);

/// Particles in order of identity, y folded.
ParticleTable table_of(const Particles& particles, const EngineSetup& setup);
/// Contacts with first < second, sorted.
std::vector<ContactState> ordered(std::vector<ContactState> contacts);

}  // namespace recoat
