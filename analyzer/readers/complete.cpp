#include "analyzer/readers/complete.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numeric>

#include <fmt/format.h>

#include "analyzer/readers/particle_types.hpp"
#include "common/error.hpp"
#include "common/tables/text_cursor.hpp"

namespace recoat {
namespace {

/// "file:line" of a particle, or "file: particle i" where the file has no lines.
std::string place(const Source& source, const std::string& file, std::size_t i) {
    if (source.line.empty()) return fmt::format("{}: particle {}", file, i);
    return fmt::format("{}:{}", file, source.line[i]);
}

void scale_lengths(Source& source, const std::string& file, const ReadOptions& options) {
    if (source.own_unit && options.length_unit && *source.own_unit != *options.length_unit) {
        throw InputError(fmt::format("{}: the file says itself that its unit of length is {} m; leave the unit out",
                                     file, *source.own_unit));
    }
    const double unit = options.length_unit.value_or(source.own_unit.value_or(1.0));
    if (unit != source.time_unit) {
        for (Vec3& v : source.velocity) v = (unit / source.time_unit) * v;
    }
    if (source.time_unit != 1) {
        for (Vec3& v : source.angular_velocity) v = (1 / source.time_unit) * v;
    }
    source.time *= source.time_unit;
    source.time_unit = 1;
    if (unit == 1) return;
    for (Vec3& p : source.position) p = unit * p;
    for (double& radius : source.radius) radius *= unit;
    if (source.box) {
        source.box->lower = unit * source.box->lower;
        source.box->upper = unit * source.box->upper;
    }
}

void set_radius(Source& source, const std::string& file, const ReadOptions& options) {
    const bool has_radius = !source.radius.empty() || source.position.empty();
    const bool given = options.radius || !options.radius_of_type.empty();
    if (!has_radius && !given) {
        throw InputError(fmt::format(
            "{}: the file gives no size of its particles under a usual name{}; name the column "
            "(--radius-column or --diameter-column) or give one radius for all, or one for each type "
            "(--radius)",
            file, source.columns.empty() ? "" : fmt::format(" (it has: {})", quotable_list(source.columns))));
    }
    if (!source.radius.empty() && given) {
        throw InputError(fmt::format("{}: the file gives the size of its particles; leave the radius out", file));
    }
    if (options.radius) source.radius.assign(source.position.size(), *options.radius);
    if (!options.radius_of_type.empty()) set_radius_of_types(source, file, options);
}

bool is_finite(Vec3 v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

void check_numbers(const Source& source, const std::string& file) {
    for (std::size_t i = 0; i < source.position.size(); ++i) {
        const Vec3 p = source.position[i];
        const double radius = source.radius[i];
        if (is_finite(p) && std::isfinite(radius) && radius > 0) continue;
        if (radius == 0) {
            throw InputError(
                fmt::format("{}: the particle has the size 0, but a particle must have a size above zero; correct it, "
                            "or leave such particles out with --skip-size-zero",
                            place(source, file, i)));
        }
        throw InputError(
            fmt::format("{}: particle {} has the centre ({}, {}, {}) and the radius {}; all must be finite, the "
                        "radius above zero",
                        file, i, p.x, p.y, p.z, radius));
    }
}

/// No metric needs them, so they must not keep a layer from being measured.
void leave_out_unknown_velocities(Source& source, const std::string& file) {
    for (auto* vectors : {&source.velocity, &source.angular_velocity}) {
        const auto unknown = std::ranges::find_if_not(*vectors, is_finite);
        if (unknown == vectors->end()) continue;
        const auto i = static_cast<std::size_t>(unknown - vectors->begin());
        const char* what = vectors == &source.velocity ? "velocity" : "angular velocity";
        source.warnings.push_back(fmt::format("{}: the {} of this particle is not finite; it is left out for all",
                                              place(source, file, i), what));
        vectors->clear();
    }
}

/// Without sorting where they are numbers from a short range, as usual.
bool all_different(std::vector<std::int64_t> id) {
    if (id.empty()) return true;
    const auto [least, largest] = std::ranges::minmax(id);
    const std::uint64_t range = static_cast<std::uint64_t>(largest) - static_cast<std::uint64_t>(least);
    constexpr std::uint64_t bits_per_id = 64;
    if (range >= bits_per_id * id.size()) {
        std::ranges::sort(id);
        return std::ranges::adjacent_find(id) == id.end();
    }
    std::vector<bool> seen(range + 1);
    for (const std::int64_t value : id) {
        const std::uint64_t place = static_cast<std::uint64_t>(value) - static_cast<std::uint64_t>(least);
        if (seen[place]) return false;
        seen[place] = true;
    }
    return true;
}

void check_identities(const Source& source, const std::string& file) {
    if (all_different(source.id)) return;
    std::vector<std::size_t> order(source.id.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::ranges::stable_sort(order, {}, [&](std::size_t i) { return source.id[i]; });
    const auto twice = std::ranges::adjacent_find(order, {}, [&](std::size_t i) { return source.id[i]; });
    if (twice == order.end()) return;
    const std::string first =
        source.line.empty() ? fmt::format("particle {}", twice[0]) : fmt::format("line {}", source.line[twice[0]]);
    throw InputError(
        fmt::format("{}: the id {} has been given to another particle already ({}); every particle needs "
                    "its own",
                    place(source, file, twice[1]), source.id[twice[1]], first));
}

/// Codes move particles back into the box now and then only, so a diameter of play, that of the largest.
void check_box(const Source& source, const std::string& file) {
    const Box& box = *source.box;
    const double play = source.radius.empty() ? 0 : 2 * std::ranges::max(source.radius);
    struct Axis {
        char name;
        double Vec3::*value;
    };
    constexpr std::array<Axis, 3> axes = {{{'x', &Vec3::x}, {'y', &Vec3::y}, {'z', &Vec3::z}}};
    for (std::size_t a = 0; a < axes.size(); ++a) {
        const double lower = box.lower.*axes[a].value, upper = box.upper.*axes[a].value;
        if (!(lower < upper)) {
            throw InputError(
                fmt::format("{}: the box ends along {} at {:.9g} m, where it has not begun yet ({:.9g} "
                            "m); correct the bounds",
                            file, axes[a].name, upper, lower));
        }
        // Along a period, a place outside is another image.
        if (box.periodic[a] || !box.closed) continue;
        for (std::size_t i = 0; i < source.position.size(); ++i) {
            const double value = source.position[i].*axes[a].value;
            if (value >= lower - play && value <= upper + play) continue;
            throw InputError(
                fmt::format("{}: the particle lies at {} = {:.9g} m, outside the box of the file, {:.9g} ... {:.9g} m; "
                            "correct the particle or the box",
                            place(source, file, i), axes[a].name, value, lower, upper));
        }
    }
}

}  // namespace

void complete(Source& source, const std::string& file, const ReadOptions& options) {
    choose_types(source, file, options);
    scale_lengths(source, file, options);
    set_radius(source, file, options);
    if (options.leave_out_size_zero) leave_out_size_zero(source, file);
    check_numbers(source, file);
    leave_out_unknown_velocities(source, file);
    check_identities(source, file);
    if (source.box) check_box(source, file);
}

}  // namespace recoat
