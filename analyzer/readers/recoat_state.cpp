#include "analyzer/readers/recoat_state.hpp"

#include <fmt/format.h>

#include "analyzer/readers/steps.hpp"
#include "common/hdf5.hpp"
#include "common/state.hpp"

namespace recoat {
namespace {

int chosen_state(const Content& content, StepChoice choice) {
    const auto root = hdf5::File::open(content.file).group("VTKHDF");
    const auto count = static_cast<std::size_t>(root.group("Steps").integer_attribute("NSteps"));
    if (count == 0 || choice.which == StepChoice::Which::last) return -1;
    const auto steps = root.dataset("FieldData/Step").read_rows<std::int64_t>(0, count);
    return static_cast<int>(choose_step(steps, choice, content.name()));
}

}  // namespace

bool is_recoat_state(const Content& content) {
    return content.bytes.starts_with("\x89HDF\r\n\x1a\n") && is_state_file(content.file);
}

Source read_recoat_state(const Content& content, const ReadOptions& options) {
    const StateInfo info = read_state_info(content.file);
    State state = read_state(content.file, chosen_state(content, options.step));
    Source source;
    source.position = std::move(state.position);
    source.radius = std::move(state.radius);
    source.id = std::move(state.id);
    source.step = state.step;
    source.own_unit = 1.0;
    source.info = {.particle_diameter = info.diameter,
                   .density = info.density,
                   .clearance = info.clearance,
                   .y_min = info.y_min,
                   .y_period = info.y_period,
                   .blade_start = info.blade_start,
                   .spread_length = info.spread_length,
                   .base = info.stage == converted_stage ? SourceInfo::unknown : 0};
    source.facts = {{"states", std::to_string(count_steps(content.file))},
                    {"step", std::to_string(state.step)},
                    {"time [s]", fmt::format("{:.9g}", state.time)},
                    {"stage", info.stage},
                    {"seed", std::to_string(info.seed)},
                    {"Bond number", fmt::format("{:.6g}", info.bond_number)},
                    {"stiffness ratio", fmt::format("{:.6g}", info.stiffness_ratio)},
                    {"written by", info.program_version}};
    return source;
}

}  // namespace recoat
