#include "analyzer/readers/columns.hpp"

#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "analyzer/readers/text_cursor.hpp"

namespace recoat {
namespace {

constexpr std::array<std::string_view, 5> radius_names = {"radius", "r", "radii", "rad", "particle_radius"};
constexpr std::array<std::string_view, 4> diameter_names = {"diameter", "d", "diam", "particle_diameter"};
constexpr std::array<std::string_view, 9> type_names = {
    "type", "types", "species", "element", "material", "matid", "material_id", "particle_type", "particletype"};
constexpr std::array<std::string_view, 4> id_names = {"id", "ids", "particle_id", "particleid"};
// The names with "lin" and "ang" are those of Yade and of LIGGGHTS.
constexpr std::array<std::string_view, 8> velocity_names = {
    "v", "velocity", "vel", "linvelvec", "velocity_lin", "linear_velocity", "velo", "velocities"};
constexpr std::array<std::string_view, 7> angular_velocity_names = {
    "omega", "angularvelocity", "angular_velocity", "angvelvec", "velocity_ang", "w", "vrot"};

std::optional<std::size_t> first_of(std::span<const std::string> names, std::span<const std::string_view> wanted) {
    for (const std::string_view name : wanted) {
        if (const auto column = find_column(names, name)) return column;
    }
    return {};
}

std::optional<VectorColumns> first_vector_of(std::span<const std::string> names,
                                             std::span<const std::string_view> wanted) {
    for (const std::string_view name : wanted) {
        for (const auto form : {"{0}{1}", "{0}_{1}", "{0}:{2}", "{0}_{2}", "{0}[{2}]"}) {
            VectorColumns columns = {};
            std::size_t found = 0;
            for (const char axis : {'x', 'y', 'z'}) {
                const auto column = find_column(names, fmt::format(fmt::runtime(form), name, axis, axis - 'x'));
                if (column) columns[found++] = *column;
            }
            if (found == columns.size()) return columns;
        }
    }
    return {};
}

}  // namespace

std::optional<std::size_t> find_column(std::span<const std::string> names, std::string_view name) {
    const auto found = std::ranges::find(names, lower_case(name));
    if (found == names.end()) return {};
    return static_cast<std::size_t>(found - names.begin());
}

std::optional<std::size_t> find_coordinate(std::span<const std::string> names, char axis) {
    // The last two: tables of ParaView.
    for (const auto form : {"{0}", "pos_{0}", "position_{0}", "p{0}", "pos{0}", "{0}_pos", "{0}pos", "center_{0}",
                            "centre_{0}", "position[{1}]", "points:{1}", "points_{1}"}) {
        if (const auto column = find_column(names, fmt::format(fmt::runtime(form), axis, axis - 'x'))) return column;
    }
    return {};
}

std::optional<std::size_t> find_id(std::span<const std::string> names) { return first_of(names, id_names); }

std::optional<VectorColumns> find_velocity(std::span<const std::string> names) {
    return first_vector_of(names, velocity_names);
}

std::optional<VectorColumns> find_angular_velocity(std::span<const std::string> names) {
    return first_vector_of(names, angular_velocity_names);
}

std::optional<std::size_t> find_type(std::span<const std::string> names, const ColumnNames& chosen,
                                     const std::function<void(const std::string&)>& fail) {
    if (chosen.type.empty()) return first_of(names, type_names);
    const auto column = find_column(names, chosen.type);
    if (!column) fail(fmt::format("there is no column \"{}\"; the file has: {}", chosen.type, quotable_list(names)));
    return column;
}

std::optional<SizeColumn> find_size(std::span<const std::string> names, const ColumnNames& chosen,
                                    const std::function<void(const std::string&)>& fail) {
    for (const auto& [name, to_radius] : {std::pair(&chosen.radius, 1.0), std::pair(&chosen.diameter, 0.5)}) {
        if (name->empty()) continue;
        if (const auto column = find_column(names, *name)) return SizeColumn{*column, to_radius};
        fail(fmt::format("there is no column \"{}\"; the file has: {}", *name, quotable_list(names)));
    }
    if (const auto column = first_of(names, radius_names)) return SizeColumn{*column, 1.0};
    if (const auto column = first_of(names, diameter_names)) return SizeColumn{*column, 0.5};
    return {};
}

}  // namespace recoat
