#include "analyzer/readers/recoat_state.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "common/error.hpp"
#include "common/hdf5.hpp"
#include "common/number.hpp"
#include "common/state.hpp"

namespace recoat {
namespace {

/// Files that older versions converted have NaN where nothing was known.
std::vector<Vec3> known(std::vector<Vec3> vectors) {
    const bool none = std::ranges::all_of(vectors, [](Vec3 v) { return std::isnan(v.x); });
    return none ? std::vector<Vec3>{} : vectors;
}

Source read_one(const std::filesystem::path& file, std::size_t index) {
    const StateInfo info = read_state_info(file);
    State state = read_state(file, static_cast<int>(index));
    const auto differs = [&](const std::vector<Vec3>& vectors) {
        return !vectors.empty() && vectors.size() != state.size();
    };
    if (state.id.size() != state.size() || state.radius.size() != state.size() || differs(state.velocity) ||
        differs(state.angular_velocity)) {
        throw InputError(
            fmt::format("{}: the arrays of state {} differ in length; the file seems damaged", file.string(), index));
    }
    Source source;
    source.position = std::move(state.position);
    source.radius = std::move(state.radius);
    source.id = std::move(state.id);
    source.velocity = known(std::move(state.velocity));
    source.angular_velocity = known(std::move(state.angular_velocity));
    if (const auto type = state.scalars.find("Type"); type != state.scalars.end()) {
        for (const double value : type->second) source.type.add(shortest(value));
    }
    source.own_unit = 1.0;
    source.info = {.particle_diameter = info.diameter,
                   .density = info.density,
                   .clearance = info.clearance,
                   .y_min = info.y_min,
                   .y_period = info.y_period,
                   .blade_start = info.blade_start,
                   .spread_length = info.spread_length,
                   .layer_end = info.layer_end,
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

bool is_recoat_state(const Content& content) { return content.is_hdf5() && is_state_file(content.file); }

Series open_recoat_state(const Content& content, const ReadOptions&) {
    const std::size_t count = count_steps(content.file);
    const auto root = hdf5::File::open(content.file).group("VTKHDF");
    return {.steps = root.dataset("FieldData/Step").read_rows<std::int64_t>(0, count),
            .read = [&content](std::size_t index) { return read_one(content.file, index); },
            .times = root.dataset("Steps/Values").read_rows<double>(0, count)};
}

}  // namespace recoat
