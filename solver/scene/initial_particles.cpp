#include "solver/scene/initial_particles.hpp"

#include <algorithm>
#include <cmath>

#include "common/error.hpp"
#include "common/number.hpp"
#include "common/state.hpp"
#include "solver/engine/limits.hpp"
#include "solver/scene/seeding.hpp"

namespace recoat {
namespace {

void refuse_other_value(const StateSource& source, const char* what, double of_state, double of_scene) {
    if (std::isnan(of_state) || std::abs(of_state - of_scene) <= 1e-9 * std::abs(of_scene)) return;
    throw InputError(source.file.string() + ": the " + what + " of the state is " + shortest(of_state) +
                     ", that of the scene " + shortest(of_scene) +
                     " (SI units); give the scene the value of the state");
}

/// Files of other codes that were converted need not say how the particles move; older ones then hold NaN.
void begin_at_rest_where_unknown(State& state, const std::filesystem::path& file, FileWarnings warnings) {
    std::string unknown;
    for (auto* velocities : {&state.velocity, &state.angular_velocity}) {
        const bool known = std::ranges::any_of(*velocities, [](Vec3 v) { return !std::isnan(v.x); });
        if (known || state.size() == 0) continue;
        velocities->assign(state.size(), {});
        unknown += unknown.empty() ? "" : " and ";
        unknown += velocities == &state.velocity ? "velocities" : "angular velocities";
    }
    if (!unknown.empty() && warnings == FileWarnings::show)
        warn("recoat-solve", file.string() + ": the state gives no " + unknown + "; they are taken as zero");
}

void refuse_unknown_velocities(const ParticleTable& particles, const std::filesystem::path& file) {
    const auto finite = [](Vec3 v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); };
    for (std::size_t i = 0; i < particles.size(); ++i) {
        if (finite(particles.velocity[i]) && finite(particles.angular_velocity[i])) continue;
        throw InputError(file.string() + ": particle " + std::to_string(i) +
                         " has a velocity or angular velocity that is not finite; correct it");
    }
}

/// The particles of a state that was made under the same conditions.
ParticleTable from_state(const StateSource& source, const Scene& scene, FileWarnings warnings) {
    const StateInfo info = read_state_info(source.file);
    refuse_other_value(source, "particle diameter", info.diameter, scene.diameter);
    refuse_other_value(source, "density", info.density, scene.model.density);
    refuse_other_value(source, "period in y", info.y_period, scene.y_period);
    State state = read_state(source.file);
    begin_at_rest_where_unknown(state, source.file, warnings);
    return {std::move(state.position), std::move(state.velocity), std::move(state.angular_velocity),
            std::move(state.radius)};
}

/// Usually another unit is the cause.
void refuse_odd_lengths(const ParticleTable& particles, const std::filesystem::path& file, double diameter) {
    constexpr double odd = 1e4;  ///< ratio of a radius to that of d_p
    constexpr double far = 1e9;  ///< radii from the origin: beyond, doubles are too coarse for overlaps
    for (std::size_t i = 0; i < particles.size(); ++i) {
        const double radius = particles.radius[i], ratio = 2 * radius / diameter;
        const Vec3 p = particles.position[i];
        const std::string who = file.string() + ": particle " + std::to_string(i);
        if (!(ratio <= odd && ratio >= 1 / odd))
            throw InputError(who + " has a radius of " + shortest(radius) + " m, " + shortest(ratio) +
                             " of that of material.diameter; check the units, lengths are in metres");
        if (!(std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)}) <= far * radius))
            throw InputError(who +
                             " is more than 1e9 radii away from the origin, too far to resolve its contacts; "
                             "check the units, or move the scene to the origin");
    }
}

/// A surface must not turn further in a step than the engine lets a particle travel.
void refuse_fast_spins(const ParticleTable& particles, const std::filesystem::path& file, double time_step) {
    for (std::size_t i = 0; i < particles.size(); ++i) {
        const double angle = norm(particles.angular_velocity[i]) * time_step;
        if (angle <= limits::travel_per_step) continue;
        throw InputError(file.string() + ": particle " + std::to_string(i) + " spins too fast: it turns by " +
                         shortest(angle) + " rad per step, more than " + shortest(limits::travel_per_step) +
                         "; reduce time_step, or its angular velocity");
    }
}

}  // namespace

ParticleTable initial_particles(const Scene& scene, FileWarnings warnings) {
    if (const auto* column = std::get_if<ColumnSource>(&scene.source)) {
        return seed_column(*column, scene.diameter, scene.y_period);
    }
    const auto* table = std::get_if<TableSource>(&scene.source);
    ParticleTable particles = table ? read_particle_csv(table->file, warnings)
                                    : from_state(std::get<StateSource>(scene.source), scene, warnings);
    const std::filesystem::path& file = table ? table->file : std::get<StateSource>(scene.source).file;
    refuse_odd_lengths(particles, file, scene.diameter);
    refuse_unknown_velocities(particles, file);
    refuse_fast_spins(particles, file, scene.time_step);
    return particles;
}

}  // namespace recoat
