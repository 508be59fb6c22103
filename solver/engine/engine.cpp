#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "common/error.hpp"
#include "solver/engine/build_engine.hpp"
#include "solver/engine/fault.hpp"
#include "solver/engine/limits.hpp"

namespace recoat {

namespace {

bool finite(Vec3 v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

void require_usable(const EngineSetup& setup, const ParticleTable& table) {
    double largest = 0;
    for (std::size_t i = 0; i < table.size(); ++i) {
        if (!finite(table.position[i]) || !finite(table.velocity[i]) || !finite(table.angular_velocity[i]))
            throw InputError(fmt::format("particle {}: a coordinate or velocity is not a finite number", i));
        if (!(table.radius[i] > 0) || !std::isfinite(table.radius[i]))
            throw InputError(fmt::format("particle {}: the radius is {} m; it must be positive", i, table.radius[i]));
        largest = std::max(largest, table.radius[i]);
    }
    const double least = 2 * (2 * largest + setup.model.cut_off + setup.skins.far * setup.diameter);
    if (setup.y_period > 0 && setup.y_period < least)
        throw InputError(
            fmt::format("the period in y is {:.4g} m, but must be at least {:.4g} m (two diameters of the "
                        "largest particle and the skin of the pair lists): widen the box",
                        setup.y_period, least));
}

[[noreturn]] void refuse(const Wall& wall, const char* problem) {
    throw InputError(fmt::format("wall '{}': {}", wall.name, problem));
}

void require_usable(const Wall& wall) {
    if (!finite(wall.velocity)) refuse(wall, "the velocity is not finite");
    if (wall.kind == WallKind::plane) {
        if (!finite(wall.point)) refuse(wall, "the point is not finite");
        if (!(std::fabs(norm(wall.normal) - 1) < 1e-9)) refuse(wall, "the normal must be a vector of length 1");
        return;
    }
    const Vec3 lo = wall.lower, hi = wall.upper;
    if (!(lo.x <= hi.x && lo.y <= hi.y && lo.z <= hi.z))
        refuse(wall, "the lower corner must not be above the upper one, and both must be numbers");
}

/// Contacts and list entries are counted with 32 bits.
void require_countable(std::size_t particles, std::size_t walls) {
    constexpr std::size_t most_contacts = 15;  // of one particle, listed
    const std::size_t most = std::numeric_limits<std::int32_t>::max() / (2 * most_contacts + walls);
    if (particles > most)
        throw InputError(
            fmt::format("{} particles are too many: with {} walls an engine takes up to {}", particles, walls, most));
}

std::unique_ptr<Engine> build(const EngineSetup& setup, Snapshot snapshot) {
    return setup.resources.backend == Backend::cuda ? build_cuda_engine(setup, std::move(snapshot))
                                                    : build_openmp_engine(setup, std::move(snapshot));
}

}  // namespace

std::unique_ptr<Engine> make_engine(const EngineSetup& setup, const ParticleTable& particles, std::vector<Wall> walls) {
    require_usable(setup, particles);
    require_countable(particles.size(), walls.size());
    for (const Wall& wall : walls) require_usable(wall);
    Snapshot snapshot = initial_snapshot(particles, std::move(walls));
    try {
        require_inside(snapshot.particles, setup, 0);
    } catch (const SimulationFault& fault) {
        throw InputError(fault.what());
    }
    return build(setup, std::move(snapshot));
}

std::unique_ptr<Engine> restore_engine(const EngineSetup& setup, const EngineState& state) {
    return build(setup, loaded(state));
}

}  // namespace recoat
