#include "analyzer/output/particle_text.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <limits>
#include <numeric>

#include <fmt/format.h>

#include "analyzer/output/identities.hpp"
#include "analyzer/output/type_numbers.hpp"
#include "common/number.hpp"

namespace recoat {
namespace {

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

/// Names of the types as words of a table: nothing in them that could end a cell.
std::vector<std::string> type_words(const Source& source) {
    std::vector<std::string> words = source.type.names;
    for (std::string& word : words) {
        std::ranges::replace_if(
            word,
            [](unsigned char c) {
                return std::isgraph(c) == 0 || std::string_view(",;|\"'").find(c) != std::string_view::npos;
            },
            '_');
        if (word.empty()) word.assign(1, '_');
    }
    return words;
}

/// The box of the file, grown to hold the particles where it does not, or the extent of the particles and the period
/// that the file tells.
Box box_of(const Source& source) {
    if (source.box && source.box->closed) return *source.box;
    Box box = source.box.value_or(Box{});
    for (std::size_t i = 0; i < source.position.size(); ++i) {
        const Vec3 p = source.position[i], low = box.lower, high = box.upper;
        const double r = source.radius[i];
        const bool first = i == 0 && !source.box;
        box.lower = {std::min(first ? p.x : low.x, p.x - r), std::min(first ? p.y : low.y, p.y - r),
                     std::min(first ? p.z : low.z, p.z - r)};
        box.upper = {std::max(first ? p.x : high.x, p.x + r), std::max(first ? p.y : high.y, p.y + r),
                     std::max(first ? p.z : high.z, p.z + r)};
    }
    if (source.position.empty() && !source.box) box.upper = {1, 1, 1};
    if (source.info.y_period > 0) {
        box.lower.y = source.info.y_min;
        box.upper.y = source.info.y_min + source.info.y_period;
        box.periodic[1] = true;
    }
    return box;
}

/// The length that leads from one bound to the other to the last bit, where there is one; else one that reaches beyond.
double side(double lower, double upper) {
    const double length = upper - lower;
    for (const double towards : {-HUGE_VAL, HUGE_VAL}) {
        const double near = std::nextafter(length, towards);
        if (lower + length != upper && lower + near == upper) return near;
    }
    return lower + length < upper ? std::nextafter(length, HUGE_VAL) : length;
}

}  // namespace

std::string csv_text(const Source& source) {
    const std::vector<std::string> types = type_words(source);
    std::string text = source.id.empty() ? "" : "id,";
    text += source.type.of.empty() ? "" : "type,";
    text += "x,y,z,radius" + velocity_names(source, ',') + "\n";
    for (std::size_t i = 0; i < source.position.size(); ++i) {
        if (!source.id.empty()) text += fmt::format("{},", source.id[i]);
        if (!source.type.of.empty()) text.append(types[source.type.of[i]]).append(1, ',');
        text += place_of(source, i, ',') + velocities_of(source, i, ',') + "\n";
    }
    return text;
}

std::string dump_text(const Source& source) {
    const Box box = box_of(source);
    std::string text;
    if (!std::isnan(source.time)) text += fmt::format("ITEM: TIME\n{}\n", shortest(source.time));
    text += fmt::format("ITEM: TIMESTEP\n{}\nITEM: NUMBER OF ATOMS\n{}\nITEM: BOX BOUNDS", source.step,
                        source.position.size());
    for (const bool periodic : box.periodic) text += periodic ? " pp" : " ff";
    text += fmt::format("\n{} {}\n{} {}\n{} {}\nITEM: ATOMS id type {} {} {} radius{}\n", shortest(box.lower.x),
                        shortest(box.upper.x), shortest(box.lower.y), shortest(box.upper.y), shortest(box.lower.z),
                        shortest(box.upper.z), box.unwrapped[0] ? "xu" : "x", box.unwrapped[1] ? "yu" : "y",
                        box.unwrapped[2] ? "zu" : "z", velocity_names(source, ' '));
    const std::vector<std::int64_t> id = identities(source);
    // Types of LAMMPS are numbers; words become their places, from 1.
    std::vector<std::int64_t> places(source.type.names.size());
    std::iota(places.begin(), places.end(), std::int64_t{1});
    const std::vector<std::int64_t> types = type_numbers(source).value_or(places);
    for (std::size_t i = 0; i < id.size(); ++i) {
        const std::int64_t type = source.type.of.empty() ? 1 : types[source.type.of[i]];
        text += fmt::format("{} {} {}{}\n", id[i], type, place_of(source, i, ' '), velocities_of(source, i, ' '));
    }
    return text;
}

std::string xyz_text(const Source& source) {
    const Box box = box_of(source);
    const bool typed = !source.type.of.empty();
    const Vec3 low = box.lower, high = box.upper;
    std::string text = fmt::format(
        "{}\nLattice=\"{} 0 0 0 {} 0 0 0 {}\" Origin=\"{} {} {}\" pbc=\"{} {} {}\" "
        "Properties={}id:I:1:pos:R:3:radius:R:1{}{} Timestep={}",
        source.position.size(), shortest(side(low.x, high.x)), shortest(side(low.y, high.y)),
        shortest(side(low.z, high.z)), shortest(low.x), shortest(low.y), shortest(low.z), box.periodic[0] ? 'T' : 'F',
        box.periodic[1] ? 'T' : 'F', box.periodic[2] ? 'T' : 'F', typed ? "species:S:1:" : "",
        source.velocity.empty() ? "" : ":velo:R:3", source.angular_velocity.empty() ? "" : ":angular_velocity:R:3",
        source.step);
    if (!std::isnan(source.time)) text += " Time=" + shortest(source.time);
    text += '\n';
    const std::vector<std::int64_t> id = identities(source);
    const std::vector<std::string> types = type_words(source);
    for (std::size_t i = 0; i < id.size(); ++i) {
        if (typed) text.append(types[source.type.of[i]]).append(1, ' ');
        text += fmt::format("{} {}{}\n", id[i], place_of(source, i, ' '), velocities_of(source, i, ' '));
    }
    return text;
}

}  // namespace recoat
