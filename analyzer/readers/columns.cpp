#include "analyzer/readers/columns.hpp"

#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "analyzer/readers/text_cursor.hpp"

namespace recoat {
namespace {

constexpr std::array<std::string_view, 5> radius_names = {"radius", "r", "radii", "rad", "particle_radius"};
constexpr std::array<std::string_view, 4> diameter_names = {"diameter", "d", "diam", "particle_diameter"};
constexpr std::array<std::string_view, 4> id_names = {"id", "ids", "particle_id", "particleid"};

std::optional<std::size_t> first_of(std::span<const std::string> names, std::span<const std::string_view> wanted) {
    for (const std::string_view name : wanted) {
        if (const auto column = find_column(names, name)) return column;
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

std::optional<SizeColumn> find_size(std::span<const std::string> names, const ColumnNames& chosen,
                                    const std::function<void(const std::string&)>& fail) {
    for (const auto& [name, to_radius] : {std::pair(&chosen.radius, 1.0), std::pair(&chosen.diameter, 0.5)}) {
        if (name->empty()) continue;
        if (const auto column = find_column(names, *name)) return SizeColumn{*column, to_radius};
        fail(fmt::format("there is no column \"{}\"; the file has: {}", *name, fmt::join(names, ", ")));
    }
    if (const auto column = first_of(names, radius_names)) return SizeColumn{*column, 1.0};
    if (const auto column = first_of(names, diameter_names)) return SizeColumn{*column, 0.5};
    return {};
}

}  // namespace recoat
