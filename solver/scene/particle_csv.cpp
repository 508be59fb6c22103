#include "solver/scene/particle_csv.hpp"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>
#include <string>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "common/error.hpp"
#include "common/tables/csv_table.hpp"
#include "common/tables/text_cursor.hpp"
#include "common/text_encoding.hpp"

namespace recoat {
namespace {

std::string text_of(const std::filesystem::path& file) {
    std::ifstream stream(file, std::ios::binary);
    if (!stream || std::filesystem::is_directory(file)) {
        throw InputError(file.string() + ": the table of particles cannot be opened; check the path");
    }
    return {std::istreambuf_iterator<char>(stream), {}};
}

[[noreturn]] void fail(const std::filesystem::path& file, std::size_t line, const std::string& sentence) {
    throw InputError(fmt::format("{}:{}: {}", file.string(), line, sentence));
}

bool is_finite(const Vec3& v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

/// Velocities of the table, all finite, or zeros where it has none.
std::vector<Vec3> velocities(std::vector<Vec3> given, const CsvTable& table, const std::filesystem::path& file,
                             std::string_view what) {
    const auto unknown = std::ranges::find_if_not(given, is_finite);
    if (unknown != given.end()) {
        fail(file, table.line[static_cast<std::size_t>(unknown - given.begin())],
             fmt::format("the {} is ({}, {}, {}), but it must be finite; correct it", what, unknown->x, unknown->y,
                         unknown->z));
    }
    given.resize(table.position.size());
    return given;
}

}  // namespace

ParticleTable read_particle_csv(const std::filesystem::path& file, FileWarnings warnings) {
    const std::string text = text_of(file);
    if (const std::string problem = wide_text_problem(text); !problem.empty()) {
        throw InputError(fmt::format("{}: {}", file.string(), problem));
    }
    CsvTable table = read_csv_table(file.string(), text, {.whole_velocities = true});
    if (table.position.empty()) {
        throw InputError(file.string() + ": the table has no particles; add a line for each");
    }
    if (!table.unused.empty()) {
        table.warnings.push_back(fmt::format("{}: columns that a table of particles does not need are passed over: {}",
                                             file.string(), quotable_list(table.unused)));
    }
    if (warnings == FileWarnings::show) {
        for (const std::string& sentence : table.warnings) warn("recoat-solve", sentence);
    }
    ParticleTable particles;
    particles.velocity = velocities(std::move(table.velocity), table, file, "velocity");
    particles.angular_velocity = velocities(std::move(table.angular_velocity), table, file, "angular velocity");
    particles.position = std::move(table.position);
    particles.radius = std::move(table.radius);
    return particles;
}

}  // namespace recoat
