#include <algorithm>

#include <fmt/format.h>

#include "common/error.hpp"
#include "common/hdf5.hpp"
#include "common/state.hpp"
#include "common/state_attributes.hpp"

namespace recoat {
namespace {

constexpr std::int64_t known_schema = 1;

const std::string usual_arrays[] = {"Id", "Radius", "Velocity", "AngularVelocity"};

std::vector<Vec3> vectors(const std::vector<double>& flat) {
    std::vector<Vec3> result(flat.size() / 3);
    for (std::size_t i = 0; i < result.size(); ++i) result[i] = {flat[3 * i], flat[3 * i + 1], flat[3 * i + 2]};
    return result;
}

hdf5::File open_state_file(const std::filesystem::path& path) {
    auto file = hdf5::File::open(path);
    if (!file.has("recoat") || !file.has("VTKHDF")) {
        throw InputError(fmt::format("{}: this HDF5 file holds no particle states; give a .vtkhdf file of recoat-solve",
                                     path.string()));
    }
    const auto version = file.group("recoat").integer_attribute("schema_version");
    if (version != known_schema) {
        throw InputError(
            fmt::format("{}: the file has schema version {}, but this program reads version {}; use the program "
                        "that wrote it",
                        path.string(), version, known_schema));
    }
    return file;
}

/// Index of the state from the start of the file.
std::size_t resolve(const std::filesystem::path& path, int index, std::int64_t steps) {
    const std::int64_t resolved = index < 0 ? steps + index : index;
    if (resolved < 0 || resolved >= steps) {
        throw InputError(
            fmt::format("{}: there is no state {}; the file has {}, counted from 0", path.string(), index, steps));
    }
    return static_cast<std::size_t>(resolved);
}

template <class Number>
Number element(const hdf5::Group& group, const std::string& name, std::size_t index) {
    return group.dataset(name).template read_rows<Number>(index, 1).at(0);
}

}  // namespace

State read_state(const std::filesystem::path& path, int index) {
    const auto file = open_state_file(path);
    const auto root = file.group("VTKHDF");
    const auto steps = root.group("Steps");
    const std::size_t s = resolve(path, index, steps.integer_attribute("NSteps"));
    const auto first = static_cast<std::size_t>(element<std::int64_t>(steps, "PointOffsets", s));
    const auto count = static_cast<std::size_t>(element<std::int64_t>(root, "NumberOfPoints", s));
    const auto points = root.group("PointData");
    const auto reals = [&](const std::string& name) { return points.dataset(name).read_rows<double>(first, count); };

    State state;
    state.time = element<double>(steps, "Values", s);
    state.step = element<std::int64_t>(root, "FieldData/Step", s);
    state.position = vectors(root.dataset("Points").read_rows<double>(first, count));
    state.id = points.dataset("Id").read_rows<std::int64_t>(first, count);
    state.radius = reals("Radius");
    if (points.has("Velocity")) state.velocity = vectors(reals("Velocity"));
    if (points.has("AngularVelocity")) state.angular_velocity = vectors(reals("AngularVelocity"));
    for (const std::string& name : points.names()) {
        const bool usual = std::find(std::begin(usual_arrays), std::end(usual_arrays), name) != std::end(usual_arrays);
        if (!usual) state.scalars[name] = reals(name);
    }
    return state;
}

std::size_t count_steps(const std::filesystem::path& path) {
    return static_cast<std::size_t>(open_state_file(path).group("VTKHDF").group("Steps").integer_attribute("NSteps"));
}

StateInfo read_state_info(const std::filesystem::path& path) {
    return read_info(open_state_file(path).group("recoat"));
}

bool is_state_file(const std::filesystem::path& path) {
    return hdf5::is_hdf5(path) && hdf5::File::open(path).has("recoat");
}

}  // namespace recoat
