#include <numeric>
#include <optional>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>

#include "common/output_file.hpp"
#include "common/polydata_file.hpp"
#include "common/state.hpp"
#include "common/state_attributes.hpp"

namespace recoat {
namespace {

void require_equal_lengths(const State& state, StateArrays arrays) {
    const std::size_t n = state.size();
    const auto require = [n](const std::string& name, std::size_t length) {
        if (length == n) return;
        throw std::invalid_argument(fmt::format("state: {} has {} values for {} particles", name, length, n));
    };
    require("id", state.id.size());
    require("velocity", arrays.velocity ? state.velocity.size() : n);
    require("angular_velocity", arrays.angular_velocity ? state.angular_velocity.size() : n);
    require("radius", state.radius.size());
    for (const auto& [name, values] : state.scalars) require(name, values.size());
}

/// One vertex per particle.
PolyCells vertices_of(const State& state) {
    PolyCells cells;
    cells.connectivity.resize(state.size());
    cells.offsets.resize(state.size() + 1);
    std::iota(cells.connectivity.begin(), cells.connectivity.end(), std::int64_t{0});
    std::iota(cells.offsets.begin(), cells.offsets.end(), std::int64_t{0});
    return cells;
}

}  // namespace

/// The file, made at the first state: a chunk holds just the particles of one.
struct StateWriter::File {
    File(std::filesystem::path place, StateInfo about, StateArrays wanted)
        : path(std::move(place)), info(std::move(about)), kept(wanted) {}

    void create(const State& state);
    void append(const State& state);

    std::filesystem::path path;
    StateInfo info;
    StateArrays kept;
    std::optional<PolyDataFile> data;
    std::size_t scalars = 0;
};

void StateWriter::File::create(const State& state) {
    data.emplace(path, state.size(), 1);
    write_info(data->root().create_group("recoat"), info);
    data->make_point_array<std::int64_t>("Id", 1, "");
    data->make_point_array<double>("Radius", 1, "m");
    if (kept.velocity) data->make_point_array<double>("Velocity", 3, "m/s");
    if (kept.angular_velocity) data->make_point_array<double>("AngularVelocity", 3, "rad/s");
    for (const auto& [name, values] : state.scalars) data->make_point_array<double>(name, 1, "");
    scalars = state.scalars.size();
}

void StateWriter::File::append(const State& state) {
    require_equal_lengths(state, kept);
    if (!data) create(state);
    if (scalars != state.scalars.size())
        throw std::invalid_argument("state: the scalars differ from those of the first state");
    for (const auto& [name, values] : state.scalars) data->add("PointData/" + name, values);
    data->add("PointData/Id", state.id);
    data->add("PointData/Radius", state.radius);
    if (kept.velocity) data->add("PointData/Velocity", state.velocity);
    if (kept.angular_velocity) data->add("PointData/AngularVelocity", state.angular_velocity);
    data->finish_step(state.time, state.step, state.position, vertices_of(state), {});
}

StateWriter::StateWriter(const std::filesystem::path& path, const StateInfo& info, StateArrays arrays)
    : output_(std::make_unique<OutputFile>(path)), file_(std::make_unique<File>(output_->path(), info, arrays)) {}
StateWriter::~StateWriter() = default;
StateWriter::StateWriter(StateWriter&&) noexcept = default;
StateWriter& StateWriter::operator=(StateWriter&&) noexcept = default;

void StateWriter::append(const State& state) { file_->append(state); }

void StateWriter::close() {
    if (!file_->data) throw std::logic_error("a state file needs at least one state");
    file_.reset();
    output_->commit();
    output_.reset();
}

void write_state(const std::filesystem::path& path, const StateInfo& info, const State& state) {
    const bool none = state.size() == 0;
    StateWriter writer(
        path, info,
        {.velocity = none || !state.velocity.empty(), .angular_velocity = none || !state.angular_velocity.empty()});
    writer.append(state);
    writer.close();
}

}  // namespace recoat
