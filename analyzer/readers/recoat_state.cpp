#include "analyzer/readers/recoat_state.hpp"

#include <fmt/format.h>

#include "common/hdf5.hpp"
#include "common/state.hpp"

namespace recoat {
namespace {

Source read_one(const std::filesystem::path& file, std::size_t index) {
    const StateInfo info = read_state_info(file);
    State state = read_state(file, static_cast<int>(index));
    Source source;
    source.position = std::move(state.position);
    source.radius = std::move(state.radius);
    source.id = std::move(state.id);
    source.own_unit = 1.0;
    source.info = {.particle_diameter = info.diameter,
                   .density = info.density,
                   .clearance = info.clearance,
                   .y_min = info.y_min,
                   .y_period = info.y_period,
                   .blade_start = info.blade_start,
                   .spread_length = info.spread_length,
                   .base = info.stage == converted_stage ? SourceInfo::unknown : 0};
    source.facts = {{"states", std::to_string(count_steps(file))},
                    {"step", std::to_string(state.step)},
                    {"time [s]", fmt::format("{:.9g}", state.time)},
                    {"stage", info.stage},
                    {"seed", std::to_string(info.seed)},
                    {"Bond number", fmt::format("{:.6g}", info.bond_number)},
                    {"stiffness ratio", fmt::format("{:.6g}", info.stiffness_ratio)},
                    {"written by", info.program_version}};
    return source;
}

}  // namespace

bool is_recoat_state(const Content& content) {
    return content.is_hdf5() && is_state_file(content.file);
}

Series open_recoat_state(const Content& content, const ReadOptions&) {
    const std::size_t count = count_steps(content.file);
    const auto root = hdf5::File::open(content.file).group("VTKHDF");
    return {root.dataset("FieldData/Step").read_rows<std::int64_t>(0, count),
            [&content](std::size_t index) { return read_one(content.file, index); }};
}

}  // namespace recoat
