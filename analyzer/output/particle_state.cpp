#include "analyzer/output/particle_state.hpp"

#include <cmath>

#include <fmt/format.h>

#include "analyzer/output/identities.hpp"
#include "analyzer/output/type_numbers.hpp"
#include "analyzer/readers/recoat_state.hpp"
#include "common/error.hpp"
#include "common/version.hpp"

namespace recoat {
namespace {

StateInfo info_of(const Source& source) {
    StateInfo info;
    info.program_version = program_version();
    info.stage = converted_stage;
    info.diameter = source.info.particle_diameter;
    info.density = source.info.density;
    info.clearance = source.info.clearance;
    info.blade_start = source.info.blade_start;
    info.spread_length = source.info.spread_length;
    info.layer_end = source.info.layer_end;
    const bool own_period = !std::isnan(source.info.y_period);
    if (own_period || (source.box && source.box->periodic[1])) {
        info.y_min = own_period ? source.info.y_min : source.box->lower.y;
        info.y_period = own_period ? source.info.y_period : source.box->upper.y - source.box->lower.y;
    }
    return info;
}

State state_of(const Source& source) {
    State state;
    state.step = source.step;
    // ParaView needs a time; where the file has none, the number of the step stands for it.
    state.time = std::isnan(source.time) ? static_cast<double>(source.step) : source.time;
    state.id = identities(source);
    state.position = source.position;
    state.radius = source.radius;
    state.velocity = source.velocity;
    state.angular_velocity = source.angular_velocity;
    const auto types = type_numbers(source);
    if (types && !source.type.of.empty()) {
        for (const std::uint32_t type : source.type.of)
            state.scalars["Type"].push_back(static_cast<double>((*types)[type]));
    }
    return state;
}

/// Arrays that a state needs to have like the first one, filled up where there are no particles.
bool fit(State& state, const State& first) {
    if (state.size() == 0) {
        for (const auto& [name, values] : first.scalars) state.scalars[name] = {};
        return true;
    }
    return state.velocity.empty() == first.velocity.empty() &&
           state.angular_velocity.empty() == first.angular_velocity.empty() &&
           state.scalars.size() == first.scalars.size();
}

}  // namespace

void StateFileWriter::add(const Source& source) {
    if (!info_) info_ = info_of(source);
    State state = state_of(source);
    if (!writer_ && state.size() == 0) {
        without_particles_.push_back(std::move(state));
        return;
    }
    append(std::move(state));
}

void StateFileWriter::append(State state) {
    if (!writer_) {
        first_ = state;
        writer_.emplace(
            place_, *info_,
            StateArrays{.velocity = !state.velocity.empty(), .angular_velocity = !state.angular_velocity.empty()});
        for (State& empty : without_particles_) {
            (void)fit(empty, first_);
            writer_->append(empty);
        }
    }
    if (!fit(state, first_)) {
        throw InputError(
            fmt::format("{}: the time step {} says other things of its particles than those before it (velocities, "
                        "types), but a VTKHDF file needs the same of all; convert to .dump or .xyz",
                        place_.string(), state.step));
    }
    writer_->append(state);
}

void StateFileWriter::finish() {
    if (!writer_) {
        // No step has particles.
        writer_.emplace(place_, info_.value_or(StateInfo{}));
        for (const State& state : without_particles_) writer_->append(state);
    }
    writer_->close();
}

}  // namespace recoat
