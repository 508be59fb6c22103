#include "common/tables/columns.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <vector>

#include <fmt/format.h>

#include "common/tables/text_cursor.hpp"

namespace recoat {
namespace {

constexpr std::array<std::string_view, 4> radius_names = {"radius", "r", "radii", "rad"};
// Of a particle, "size" is the size of a sieve that it just passes: a diameter.
constexpr std::array<std::string_view, 4> diameter_names = {"diameter", "d", "diam", "particle_size"};
constexpr std::array<std::string_view, 9> type_names = {
    "type", "types", "species", "element", "material", "matid", "material_id", "particletype", "material_type"};
constexpr std::array<std::string_view, 3> id_names = {"id", "ids", "particleid"};
constexpr std::array<std::string_view, 13> coordinate_names = {
    "{0}",          "pos_{0}",    "position_{0}", "p{0}",           "pos{0}",         "{0}_pos",        "{0}pos",
    "{0}_position", "center_{0}", "centre_{0}",   "{0}_coordinate", "coordinate_{0}", "coordinates_{0}"};
// Of arrays of vectors: tables of ParaView, VTK.
constexpr std::array<std::string_view, 3> indexed_coordinate_names = {"position_{1}", "points_{1}", "coordinates_{1}"};
// The names with "lin" and "ang" are those of Yade and of LIGGGHTS.
constexpr std::array<std::string_view, 9> velocity_names = {
    "v",    "velocity",  "vel", "linvelvec", "velocity_lin", "linear_velocity", "translational_velocity",
    "velo", "velocities"};
constexpr std::array<std::string_view, 8> angular_velocity_names = {
    "omega", "angularvelocity", "angular_velocity", "angvelvec", "velocity_ang", "w", "rotational_velocity", "vrot"};
constexpr std::array<std::string_view, 4> vector_forms = {"{0}{1}", "{0}_{1}", "{0}_{2}", "{1}_{0}"};

/// The name in small letters, with one '_' for each row of signs and blanks in it.
std::string plain_form(std::string_view name) {
    std::string result;
    for (const char c : name) {
        const auto letter = static_cast<unsigned char>(c);
        if (std::isalnum(letter) != 0 || letter >= 0x80) {
            result += static_cast<char>(std::tolower(letter));
        } else if (!result.empty() && result.back() != '_') {
            result += '_';
        }
    }
    if (result.ends_with('_')) result.pop_back();
    return result;
}

std::vector<std::string> plain_forms(std::span<const std::string> names) {
    std::vector<std::string> result;
    result.reserve(names.size());
    for (const std::string& name : names) result.push_back(plain_form(name));
    return result;
}

/// Place of a name, or of the same name with "particle" before it.
std::optional<std::size_t> find_plain(const std::vector<std::string>& forms, const std::string& name) {
    for (const std::string& wanted : {name, "particle_" + name}) {
        const auto found = std::ranges::find(forms, wanted);
        if (found != forms.end()) return static_cast<std::size_t>(found - forms.begin());
    }
    return {};
}

std::optional<std::size_t> first_of(const std::vector<std::string>& forms, std::span<const std::string_view> wanted) {
    for (const std::string_view name : wanted) {
        if (const auto column = find_plain(forms, std::string(name))) return column;
    }
    return {};
}

/// Components of a vector that are there, in their order.
using Components = std::vector<std::size_t>;

/// The components with the first of these names of which at least so many are there.
Components first_vector_of(std::span<const std::string> names, std::span<const std::string_view> wanted,
                           std::size_t least) {
    const std::vector<std::string> forms = plain_forms(names);
    for (const std::string_view name : wanted) {
        for (const std::string_view form : vector_forms) {
            Components found;
            for (const char axis : {'x', 'y', 'z'}) {
                const auto column = find_plain(forms, fmt::format(fmt::runtime(form), name, axis, axis - 'x'));
                if (column) found.push_back(*column);
            }
            if (found.size() >= least) return found;
        }
    }
    return {};
}

std::optional<VectorColumns> whole_vector_of(std::span<const std::string> names,
                                             std::span<const std::string_view> wanted) {
    const Components found = first_vector_of(names, wanted, 3);
    if (found.empty()) return {};
    return VectorColumns{found[0], found[1], found[2]};
}

}  // namespace

std::optional<std::size_t> find_column(std::span<const std::string> names, std::string_view name) {
    const auto found = std::ranges::find(names, lower_case(name));
    if (found == names.end()) return {};
    return static_cast<std::size_t>(found - names.begin());
}

std::optional<std::size_t> find_coordinate(std::span<const std::string> names, char axis) {
    const std::vector<std::string> forms = plain_forms(names);
    for (const std::span<const std::string_view> wanted :
         {std::span<const std::string_view>(coordinate_names),
          std::span<const std::string_view>(indexed_coordinate_names)}) {
        for (const std::string_view form : wanted) {
            const auto column = find_plain(forms, fmt::format(fmt::runtime(form), axis, axis - 'x'));
            if (column) return column;
        }
    }
    return {};
}

std::optional<std::size_t> find_id(std::span<const std::string> names) {
    return first_of(plain_forms(names), id_names);
}

std::optional<VectorColumns> find_velocity(std::span<const std::string> names) {
    return whole_vector_of(names, velocity_names);
}

std::optional<VectorColumns> find_angular_velocity(std::span<const std::string> names) {
    return whole_vector_of(names, angular_velocity_names);
}

std::optional<std::size_t> find_part_of_velocity(std::span<const std::string> names) {
    for (const auto& [whole, wanted] :
         {std::pair(find_velocity(names), std::span<const std::string_view>(velocity_names)),
          std::pair(find_angular_velocity(names), std::span<const std::string_view>(angular_velocity_names))}) {
        if (whole) continue;
        const Components found = first_vector_of(names, wanted, 1);
        if (!found.empty()) return found.front();
    }
    return {};
}

std::optional<std::size_t> find_usual_type(std::span<const std::string> names) {
    return first_of(plain_forms(names), type_names);
}

std::optional<std::size_t> find_type(std::span<const std::string> names, const ColumnNames& chosen,
                                     const std::function<void(const std::string&)>& fail) {
    if (chosen.type.empty()) return find_usual_type(names);
    const auto column = find_column(names, chosen.type);
    if (!column) {
        fail(fmt::format("there is no column \"{}\"; the file has: {}", quotable(chosen.type), quotable_list(names)));
    }
    return column;
}

std::optional<SizeColumn> find_usual_size(std::span<const std::string> names) {
    const std::vector<std::string> forms = plain_forms(names);
    if (const auto column = first_of(forms, radius_names)) return SizeColumn{*column, 1.0};
    if (const auto column = first_of(forms, diameter_names)) return SizeColumn{*column, 0.5};
    return {};
}

std::optional<SizeColumn> find_size(std::span<const std::string> names, const ColumnNames& chosen,
                                    const std::function<void(const std::string&)>& fail) {
    for (const auto& [name, to_radius] : {std::pair(&chosen.radius, 1.0), std::pair(&chosen.diameter, 0.5)}) {
        if (name->empty()) continue;
        if (const auto column = find_column(names, *name)) return SizeColumn{*column, to_radius};
        fail(fmt::format("there is no column \"{}\"; the file has: {}", quotable(*name), quotable_list(names)));
    }
    return find_usual_size(names);
}

}  // namespace recoat
