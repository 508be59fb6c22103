#include "solver/scene/initial_particles.hpp"

#include "common/state.hpp"
#include "solver/scene/particle_csv.hpp"
#include "solver/scene/seeding.hpp"

namespace recoat {
namespace {

ParticleTable from_state(const StateSource& source) {
    State state = read_state(source.file);
    return {std::move(state.position), std::move(state.velocity), std::move(state.angular_velocity),
            std::move(state.radius)};
}

}  // namespace

ParticleTable initial_particles(const Scene& scene) {
    if (const auto* column = std::get_if<ColumnSource>(&scene.source)) {
        return seed_column(*column, scene.diameter, scene.y_period);
    }
    if (const auto* table = std::get_if<TableSource>(&scene.source)) return read_particle_csv(table->file);
    return from_state(std::get<StateSource>(scene.source));
}

}  // namespace recoat
