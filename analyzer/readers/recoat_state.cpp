#include "analyzer/readers/recoat_state.hpp"

#include <fmt/format.h>

#include "common/state.hpp"

namespace recoat {

bool is_recoat_state(const std::filesystem::path& file, std::string_view head) {
    return head.starts_with("\x89HDF\r\n\x1a\n") && is_state_file(file);
}

Source read_recoat_state(const std::filesystem::path& file, const ColumnNames&) {
    const StateInfo info = read_state_info(file);
    State state = read_state(file);
    Source source;
    source.position = std::move(state.position);
    source.radius = std::move(state.radius);
    source.info = {.particle_diameter = info.diameter,
                   .density = info.density,
                   .clearance = info.clearance,
                   .y_min = info.y_min,
                   .y_period = info.y_period,
                   .blade_start = info.blade_start,
                   .spread_length = info.spread_length};
    source.facts = {{"states", std::to_string(count_steps(file))},
                    {"time [s]", fmt::format("{:.9g}", state.time)},
                    {"stage", info.stage},
                    {"seed", std::to_string(info.seed)},
                    {"Bond number", fmt::format("{:.6g}", info.bond_number)},
                    {"stiffness ratio", fmt::format("{:.6g}", info.stiffness_ratio)},
                    {"written by", info.program_version}};
    return source;
}

}  // namespace recoat
