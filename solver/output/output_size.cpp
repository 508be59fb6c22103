#include "solver/output/output_size.hpp"

#include <limits>

#include <fmt/format.h>

#include "common/readable.hpp"
#include "solver/output/energy_series.hpp"

namespace recoat {
namespace {

namespace fs = std::filesystem;

/// Of a particle in a state file: place, velocity and spin (3 reals each), radius, coordination number, id, and two
/// integers that make it a vertex. Deflated they take a little less [docs/schema.md].
constexpr double bytes_of_particle = 8.0 * (3 * 3 + 2 + 1 + 2);
constexpr double bytes_of_state = 24e3;  ///< the rest of the file: names, attributes, configuration
constexpr double bytes_of_number = 21;   ///< in a table, with the comma

}  // namespace

OutputSize output_size(const Scene& scene, std::int64_t particles, double checkpoint) {
    std::int64_t steps = 0;
    for (const Stage& stage : scene.stages) steps += stage.steps();
    const auto times = [&](std::int64_t interval) { return interval > 0 ? steps / interval + 1 : 0; };
    OutputSize size;
    size.frame = bytes_of_state + bytes_of_particle * static_cast<double>(particles);
    size.frames = times(scene.output.trajectory_interval);
    size.states = static_cast<double>(scene.stages.size()) * size.frame;
    size.checkpoints = 2 * checkpoint;
    size.series = static_cast<double>(times(scene.output.energy_interval)) * bytes_of_number *
                  static_cast<double>(EnergySeries::columns());
    return size;
}

double engine_bytes(const EngineState& state) {
    std::size_t numbers = 0;
    for (const auto& [name, values] : state.reals) numbers += values.size();
    for (const auto& [name, values] : state.integers) numbers += values.size();
    return 8.0 * static_cast<double>(numbers);
}

double free_bytes(const fs::path& folder) {
    fs::path place = fs::absolute(folder.empty() ? "." : folder);
    std::error_code error;
    while (!fs::exists(place, error) && place.has_parent_path() && place != place.root_path())
        place = place.parent_path();
    const fs::space_info space = fs::space(place, error);
    return error ? std::numeric_limits<double>::infinity() : static_cast<double>(space.available);
}

std::string space_note(const OutputSize& size, const fs::path& folder) {
    const double free = free_bytes(folder);
    if (size.most() <= free) return {};
    const std::string what =
        size.trajectory() > 0.5 * size.left()
            ? fmt::format(", most of it {} states of the trajectory; give a longer output.trajectory_interval, or",
                          readable_count(size.frames))
            : ";";
    return fmt::format("the output takes up to {}, but the disk has {} free{} choose another disk for --out",
                       readable_bytes(size.most()), readable_bytes(free), what);
}

}  // namespace recoat
