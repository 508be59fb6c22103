#include "analyzer/output/particle_file.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <numeric>

#include <fmt/format.h>

#include "analyzer/output/particle_vtp.hpp"
#include "analyzer/readers/recoat_state.hpp"
#include "common/error.hpp"
#include "common/number.hpp"
#include "common/output_file.hpp"
#include "common/state.hpp"
#include "common/version.hpp"

namespace recoat {
namespace {

namespace fs = std::filesystem;

/// Identities of the file, or else 1, 2, 3 ...
std::vector<std::int64_t> identities(const Source& source) {
    if (!source.id.empty()) return source.id;
    std::vector<std::int64_t> id(source.position.size());
    std::iota(id.begin(), id.end(), std::int64_t{1});
    return id;
}

std::string place_of(const Source& source, std::size_t i, char separator) {
    const Vec3 p = source.position[i];
    return fmt::format("{1}{0}{2}{0}{3}{0}{4}", separator, shortest(p.x), shortest(p.y), shortest(p.z),
                       shortest(source.radius[i]));
}

/// Names of the columns of the velocities that the particles have, each behind a separator.
std::string velocity_names(const Source& source, char separator) {
    std::string text;
    if (!source.velocity.empty()) text += fmt::format("{0}vx{0}vy{0}vz", separator);
    if (!source.angular_velocity.empty()) text += fmt::format("{0}omegax{0}omegay{0}omegaz", separator);
    return text;
}

/// Velocities of a particle under these names.
std::string velocities_of(const Source& source, std::size_t i, char separator) {
    std::string text;
    for (const auto* values : {&source.velocity, &source.angular_velocity}) {
        if (values->empty()) continue;
        const Vec3 v = (*values)[i];
        text += fmt::format("{0}{1}{0}{2}{0}{3}", separator, shortest(v.x), shortest(v.y), shortest(v.z));
    }
    return text;
}

void write_csv(const fs::path& place, const Source& source) {
    std::string text = source.id.empty() ? "x,y,z,radius" : "id,x,y,z,radius";
    text += velocity_names(source, ',') + "\n";
    for (std::size_t i = 0; i < source.position.size(); ++i) {
        if (!source.id.empty()) text += fmt::format("{},", source.id[i]);
        text += place_of(source, i, ',') + velocities_of(source, i, ',') + "\n";
    }
    write_text_file(place, text);
}

/// The box of the file, or the extent of the particles and the period that the file tells.
Box box_of(const Source& source) {
    if (source.box) return *source.box;
    Box box;
    for (std::size_t i = 0; i < source.position.size(); ++i) {
        const Vec3 p = source.position[i], low = box.lower, high = box.upper;
        const double r = source.radius[i];
        const bool first = i == 0;
        box.lower = {std::min(first ? p.x : low.x, p.x - r), std::min(first ? p.y : low.y, p.y - r),
                     std::min(first ? p.z : low.z, p.z - r)};
        box.upper = {std::max(first ? p.x : high.x, p.x + r), std::max(first ? p.y : high.y, p.y + r),
                     std::max(first ? p.z : high.z, p.z + r)};
    }
    if (source.position.empty()) box.upper = {1, 1, 1};
    if (source.info.y_period > 0) {
        box.lower.y = source.info.y_min;
        box.upper.y = source.info.y_min + source.info.y_period;
        box.periodic[1] = true;
    }
    return box;
}

void write_lammps_dump(const fs::path& place, const Source& source) {
    const Box box = box_of(source);
    std::string text = fmt::format("ITEM: TIMESTEP\n{}\nITEM: NUMBER OF ATOMS\n{}\nITEM: BOX BOUNDS", source.step,
                                   source.position.size());
    for (const bool periodic : box.periodic) text += periodic ? " pp" : " ff";
    text += fmt::format("\n{} {}\n{} {}\n{} {}\nITEM: ATOMS id type {} {} {} radius{}\n", shortest(box.lower.x),
                        shortest(box.upper.x), shortest(box.lower.y), shortest(box.upper.y), shortest(box.lower.z),
                        shortest(box.upper.z), box.unwrapped[0] ? "xu" : "x", box.unwrapped[1] ? "yu" : "y",
                        box.unwrapped[2] ? "zu" : "z", velocity_names(source, ' '));
    const std::vector<std::int64_t> id = identities(source);
    for (std::size_t i = 0; i < id.size(); ++i) {
        text += fmt::format("{} 1 {}{}\n", id[i], place_of(source, i, ' '), velocities_of(source, i, ' '));
    }
    write_text_file(place, text);
}

void write_vtkhdf(const fs::path& place, const Source& source) {
    StateInfo info;
    info.program_version = program_version();
    info.stage = converted_stage;
    info.diameter = source.info.particle_diameter;
    info.density = source.info.density;
    info.clearance = source.info.clearance;
    info.blade_start = source.info.blade_start;
    info.spread_length = source.info.spread_length;
    const bool own_period = !std::isnan(source.info.y_period);
    if (own_period || (source.box && source.box->periodic[1])) {
        info.y_min = own_period ? source.info.y_min : source.box->lower.y;
        info.y_period = own_period ? source.info.y_period : source.box->upper.y - source.box->lower.y;
    }
    State state;
    state.step = source.step;
    state.id = identities(source);
    state.position = source.position;
    state.radius = source.radius;
    const Vec3 unknown = {StateInfo::unknown, StateInfo::unknown, StateInfo::unknown};
    state.velocity = source.velocity;
    state.angular_velocity = source.angular_velocity;
    for (auto* values : {&state.velocity, &state.angular_velocity}) {
        if (values->empty()) values->assign(state.size(), unknown);
    }
    write_state(place, info, state);
}

struct Format {
    std::string_view name, ending;
    void (*write)(const fs::path&, const Source&);
};
constexpr std::array<Format, 6> formats = {{{"csv", ".csv", write_csv},
                                            {"vtp", ".vtp", write_vtp},
                                            {"lammps-dump", ".dump", write_lammps_dump},
                                            {"lammps-dump", ".lammpstrj", write_lammps_dump},
                                            {"vtkhdf", ".vtkhdf", write_vtkhdf},
                                            {"vtkhdf", ".hdf", write_vtkhdf}}};

}  // namespace

void write_particle_file(const fs::path& place, const std::string& format, const Source& source) {
    const std::string ending = place.extension().string();
    const auto found = std::ranges::find_if(
        formats, [&](const Format& known) { return format.empty() ? known.ending == ending : known.name == format; });
    if (found == formats.end()) {
        throw InputError(fmt::format("{}: {}; give --format csv, vtp, lammps-dump or vtkhdf", place.string(),
                                     format.empty() ? "the ending tells no format that can be written"
                                                    : fmt::format("no format \"{}\" can be written", format)));
    }
    found->write(place, source);
}

}  // namespace recoat
