#include <algorithm>
#include <numeric>
#include <stdexcept>

#include <fmt/format.h>

#include "common/hdf5.hpp"
#include "common/output_file.hpp"
#include "common/state.hpp"
#include "common/state_attributes.hpp"

namespace recoat {
namespace {

using hdf5::Dataset;
using hdf5::Group;
using Integers = std::vector<std::int64_t>;

constexpr std::size_t steps_per_chunk = 64;

std::vector<double> flat(const std::vector<Vec3>& vectors) {
    std::vector<double> values;
    values.reserve(3 * vectors.size());
    for (const Vec3& v : vectors) values.insert(values.end(), {v.x, v.y, v.z});
    return values;
}

Integers counted(std::size_t count) {
    Integers values(count);
    std::iota(values.begin(), values.end(), std::int64_t{0});
    return values;
}

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

/// Names follow the VTKHDF rules: a dot or slash would hide the array from readers.
void require_valid_name(const std::string& name) {
    if (name.empty() || name.find_first_of("./") != std::string::npos) {
        throw std::invalid_argument(fmt::format("state: \"{}\" cannot be the name of a point array", name));
    }
}

}  // namespace

/// The open file. Arrays are made at the first state, so that a chunk holds just the particles of one.
struct StateWriter::File {
    File(const std::filesystem::path& path, const StateInfo& info, StateArrays wanted)
        : kept(wanted), file(hdf5::File::create(path)), root(file.create_group("VTKHDF")) {
        write_info(file.create_group("recoat"), info);
        root.set_attribute("Version", Integers{2, 0});
        root.set_attribute("Type", std::string("PolyData"));
    }

    void create(const State& state);
    void create_cells(const std::string& kind);
    void create_steps();
    void create_point_array(const std::string& name, std::size_t components, const std::string& unit);
    void append(const State& state);
    void append_cells(std::size_t particles);
    void append_steps(const State& state);

    void add(const std::string& name, const Integers& values) { arrays.at(name).append(values); }
    void add(const std::string& name, const std::vector<double>& values) { arrays.at(name).append(values); }

    template <class Number>
    void make(const std::string& name, const hdf5::Shape& row = {}, std::size_t rows_per_chunk = steps_per_chunk) {
        arrays.emplace(name, root.create_extendible<Number>(name, row, rows_per_chunk));
    }

    StateArrays kept;
    hdf5::File file;
    Group root;
    std::map<std::string, Dataset> arrays;  ///< by their path below /VTKHDF
    std::size_t particles_per_chunk = 1;
    std::int64_t steps = 0;
    std::int64_t points = 0;  ///< of all states so far
};

void StateWriter::File::create_cells(const std::string& kind) {
    root.create_group(kind);
    const std::size_t chunk = kind == "Vertices" ? particles_per_chunk + 1 : steps_per_chunk;
    make<std::int64_t>(kind + "/NumberOfCells");
    make<std::int64_t>(kind + "/NumberOfConnectivityIds");
    make<std::int64_t>(kind + "/Connectivity", {}, chunk);
    make<std::int64_t>(kind + "/Offsets", {}, chunk);
}

void StateWriter::File::create_point_array(const std::string& name, std::size_t components, const std::string& unit) {
    const hdf5::Shape row = components == 1 ? hdf5::Shape{} : hdf5::Shape{components};
    if (name == "PointData/Id") {
        make<std::int64_t>(name, row, particles_per_chunk);
    } else {
        make<double>(name, row, particles_per_chunk);
    }
    if (!unit.empty()) root.set_dataset_attribute(name, "unit", unit);
    if (name.starts_with("PointData/")) make<std::int64_t>("Steps/PointDataOffsets/" + name.substr(10));
}

void StateWriter::File::create_steps() {
    for (const auto* group : {"Steps", "Steps/PointDataOffsets", "Steps/FieldDataOffsets", "Steps/FieldDataSizes",
                              "FieldData", "PointData"}) {
        root.create_group(group);
    }
    make<double>("Steps/Values");
    for (const auto* name : {"PartOffsets", "NumberOfParts", "PointOffsets"})
        make<std::int64_t>(fmt::format("Steps/{}", name));
    make<std::int64_t>("Steps/CellOffsets", {4});
    make<std::int64_t>("Steps/ConnectivityIdOffsets", {4});
    make<double>("FieldData/Time");
    make<std::int64_t>("FieldData/Step");
    root.set_dataset_attribute("FieldData/Time", "unit", "s");
    for (const auto* name : {"Time", "Step"}) {
        make<std::int64_t>(fmt::format("Steps/FieldDataOffsets/{}", name));
        make<std::int64_t>(fmt::format("Steps/FieldDataSizes/{}", name), {2});
    }
}

void StateWriter::File::create(const State& state) {
    particles_per_chunk = std::max<std::size_t>(1, state.size());
    make<std::int64_t>("NumberOfPoints");
    for (const auto* kind : {"Vertices", "Lines", "Polygons", "Strips"}) create_cells(kind);
    create_steps();
    create_point_array("Points", 3, "m");
    create_point_array("PointData/Id", 1, "");
    create_point_array("PointData/Radius", 1, "m");
    if (kept.velocity) create_point_array("PointData/Velocity", 3, "m/s");
    if (kept.angular_velocity) create_point_array("PointData/AngularVelocity", 3, "rad/s");
    for (const auto& [name, values] : state.scalars) {
        require_valid_name(name);
        create_point_array("PointData/" + name, 1, "");
    }
}

void StateWriter::File::append_cells(std::size_t particles) {
    const auto count = static_cast<std::int64_t>(particles);
    add("Vertices/NumberOfCells", Integers{count});
    add("Vertices/NumberOfConnectivityIds", Integers{count});
    add("Vertices/Connectivity", counted(particles));
    add("Vertices/Offsets", counted(particles + 1));
    for (const std::string kind : {"Lines", "Polygons", "Strips"}) {
        add(kind + "/NumberOfCells", Integers{0});
        add(kind + "/NumberOfConnectivityIds", Integers{0});
        add(kind + "/Offsets", Integers{0});
    }
}

void StateWriter::File::append_steps(const State& state) {
    add("Steps/Values", std::vector{state.time});
    add("Steps/PartOffsets", Integers{steps});
    add("Steps/NumberOfParts", Integers{1});
    add("Steps/PointOffsets", Integers{points});
    add("Steps/CellOffsets", Integers{points, 0, 0, 0});
    add("Steps/ConnectivityIdOffsets", Integers{points, 0, 0, 0});
    add("FieldData/Time", std::vector{state.time});
    add("FieldData/Step", Integers{state.step});
    for (const std::string name : {"Time", "Step"}) {
        add("Steps/FieldDataOffsets/" + name, Integers{steps});
        add("Steps/FieldDataSizes/" + name, Integers{1, 1});
    }
    for (auto& [name, array] : arrays) {
        if (name.starts_with("Steps/PointDataOffsets/")) array.append(Integers{points});
    }
}

void StateWriter::File::append(const State& state) {
    require_equal_lengths(state, kept);
    if (steps == 0) create(state);
    const std::size_t known = std::count_if(arrays.begin(), arrays.end(),
                                            [](const auto& entry) { return entry.first.starts_with("PointData/"); });
    if (known != state.scalars.size() + 2 + (kept.velocity ? 1 : 0) + (kept.angular_velocity ? 1 : 0))
        throw std::invalid_argument("state: the scalars differ from those of the first state");
    for (const auto& [name, values] : state.scalars) add("PointData/" + name, values);
    add("Points", flat(state.position));
    add("PointData/Id", state.id);
    add("PointData/Radius", state.radius);
    if (kept.velocity) add("PointData/Velocity", flat(state.velocity));
    if (kept.angular_velocity) add("PointData/AngularVelocity", flat(state.angular_velocity));
    add("NumberOfPoints", Integers{static_cast<std::int64_t>(state.size())});
    append_cells(state.size());
    append_steps(state);
    points += static_cast<std::int64_t>(state.size());
    ++steps;
    // Last, so that a reader never meets a step that is not whole.
    root.group("Steps").set_attribute("NSteps", steps);
    file.flush();
}

StateWriter::StateWriter(const std::filesystem::path& path, const StateInfo& info, StateArrays arrays)
    : output_(std::make_unique<OutputFile>(path)), file_(std::make_unique<File>(output_->path(), info, arrays)) {}
StateWriter::~StateWriter() = default;
StateWriter::StateWriter(StateWriter&&) noexcept = default;
StateWriter& StateWriter::operator=(StateWriter&&) noexcept = default;

void StateWriter::append(const State& state) { file_->append(state); }

void StateWriter::close() {
    if (file_->steps == 0) throw std::logic_error("a state file needs at least one state");
    file_->file.flush();
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
