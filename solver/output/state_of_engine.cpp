#include "solver/output/state_of_engine.hpp"

#include <numeric>

#include "common/version.hpp"
#include "solver/output/coordination.hpp"

namespace recoat {

State state_of_engine(const Engine& engine, double y_period) {
    ParticleTable particles = engine.particles();
    State state;
    state.time = engine.time();
    state.step = engine.step();
    state.id.resize(particles.size());
    std::iota(state.id.begin(), state.id.end(), std::int64_t{0});
    state.scalars["CoordinationNumber"] = coordination_numbers(particles, y_period);
    state.position = std::move(particles.position);
    state.velocity = std::move(particles.velocity);
    state.angular_velocity = std::move(particles.angular_velocity);
    state.radius = std::move(particles.radius);
    return state;
}

StateInfo state_info(const Scene& scene, const std::string& stage, Backend backend) {
    StateInfo info;
    info.program_version = program_version();
    info.config = scene.resolved;
    info.backend = name_of(backend);
    info.stage = stage;
    info.seed = scene.seed;
    info.diameter = scene.diameter;
    info.density = scene.model.density;
    if (scene.y_period > 0) {
        info.y_min = 0;
        info.y_period = scene.y_period;
    }
    if (scene.spread) {
        info.clearance = scene.spread->clearance;
        info.blade_start = scene.spread->blade_start;
        info.spread_length = scene.spread->length;
    }
    info.bond_number = scene.bond_number;
    info.hamaker = scene.model.hamaker;
    info.stiffness_ratio = scene.model.stiffness_ratio;
    info.time_step = scene.time_step;
    return info;
}

}  // namespace recoat
