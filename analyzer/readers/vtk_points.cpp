#include "analyzer/readers/vtk_points.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include <fmt/format.h>

#include "analyzer/readers/columns.hpp"
#include "analyzer/readers/text_cursor.hpp"
#include "common/error.hpp"

namespace recoat {
namespace {

/// Identities, which some programs write as real numbers; none where they are no whole numbers.
std::vector<std::int64_t> whole_numbers(std::span<const double> values) {
    constexpr double largest = 0x1p53;
    if (!std::ranges::all_of(values, [](double v) { return v == std::floor(v) && std::abs(v) <= largest; })) return {};
    return {values.begin(), values.end()};
}

}  // namespace

bool VtkPoints::wanted(std::string_view name, const ColumnNames& chosen) {
    const std::array<std::string, 1> names = {lower_case(name)};
    const bool size = find_size(names, {}, [](const std::string&) {}).has_value();
    return size || find_id(names) || names[0] == lower_case(chosen.radius) || names[0] == lower_case(chosen.diameter);
}

Source particles_from(VtkPoints points, const ColumnNames& chosen, const std::string& file) {
    Source source;
    source.position = std::move(points.position);
    const auto size = find_size(points.names, chosen, [&](const std::string& problem) {
        throw InputError(fmt::format("{}: {}", file, problem));
    });
    if (size) {
        source.radius = points.arrays[size->index];
        for (double& value : source.radius) value *= size->to_radius;
        source.facts.emplace_back("size from", points.names[size->index]);
    }
    if (const auto id = find_id(points.names)) source.id = whole_numbers(points.arrays[*id]);
    return source;
}

}  // namespace recoat
