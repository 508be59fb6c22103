#include "analyzer/readers/vtk_points.hpp"

#include <algorithm>
#include <array>
#include <span>

#include <fmt/format.h>

#include "analyzer/readers/particle_types.hpp"
#include "common/error.hpp"
#include "common/number.hpp"
#include "common/tables/columns.hpp"
#include "common/tables/text_cursor.hpp"

namespace recoat {
namespace {

/// Marks of points that stand in a piece only because they border on it; another piece has them as its own.
std::optional<std::size_t> find_ghosts(std::span<const std::string> names) {
    const auto type = find_column(names, "vtkghosttype");
    return type ? type : find_column(names, "vtkghostlevels");
}

std::string column_name(std::string_view array, std::size_t components, std::size_t index) {
    return components == 1 ? lower_case(array) : fmt::format("{}:{}", lower_case(array), index);
}

std::vector<Vec3> vectors(const VtkPoints& points, const VectorColumns& columns) {
    std::vector<Vec3> result(points.position.size());
    for (std::size_t i = 0; i < result.size(); ++i) {
        result[i] = {points.arrays[columns[0]][i], points.arrays[columns[1]][i], points.arrays[columns[2]][i]};
    }
    return result;
}

}  // namespace

bool VtkPoints::wanted(std::string_view name, std::size_t components, const ColumnNames& chosen) {
    if (components == 3) {
        const std::array<std::string, 3> names = {column_name(name, 3, 0), column_name(name, 3, 1),
                                                  column_name(name, 3, 2)};
        return find_velocity(names) || find_angular_velocity(names);
    }
    if (components != 1) return false;
    const std::array<std::string, 1> names = {lower_case(name)};
    const bool size = find_size(names, {}, [](const std::string&) {}).has_value();
    return size || find_id(names) || find_ghosts(names) || find_type(names, {}, [](const std::string&) {}) ||
           names[0] == lower_case(chosen.radius) || names[0] == lower_case(chosen.diameter) ||
           names[0] == lower_case(chosen.type);
}

bool VtkPoints::holds_identities(std::string_view name, std::size_t components) {
    const std::array<std::string, 1> names = {lower_case(name)};
    return components == 1 && find_id(names);
}

void VtkPoints::append_identities(const std::optional<std::vector<std::int64_t>>& values) {
    if (values) identities.insert(identities.end(), values->begin(), values->end());
}

void VtkPoints::offer(const std::string& name) {
    std::string plain = lower_case(name);
    if (std::ranges::find(offered, plain) == offered.end()) offered.push_back(std::move(plain));
}

void VtkPoints::append_positions(std::span<const double> flat) {
    position.reserve(position.size() + flat.size() / 3);
    for (std::size_t i = 0; i + 2 < flat.size(); i += 3) position.push_back({flat[i], flat[i + 1], flat[i + 2]});
}

void VtkPoints::append(std::string_view name, std::size_t components, std::span<const double> values) {
    for (std::size_t c = 0; c < components; ++c) {
        std::string column = column_name(name, components, c);
        auto place = static_cast<std::size_t>(std::ranges::find(names, column) - names.begin());
        if (place == names.size()) {
            names.push_back(std::move(column));
            arrays.emplace_back();
        }
        auto& array = arrays[place];
        array.reserve(array.size() + values.size() / components);
        for (std::size_t i = c; i < values.size(); i += components) array.push_back(values[i]);
    }
}

std::optional<std::size_t> VtkPoints::find(std::string_view name, std::size_t components) const {
    return find_column(names, column_name(name, components, 0));
}

Source particles_from(VtkPoints points, const ColumnNames& chosen, const std::string& file) {
    Source source;
    if (const auto columns = find_velocity(points.names)) source.velocity = vectors(points, *columns);
    if (const auto columns = find_angular_velocity(points.names)) source.angular_velocity = vectors(points, *columns);
    source.position = std::move(points.position);
    source.columns = points.offered;
    for (const std::string* name : {&chosen.radius, &chosen.diameter, &chosen.type}) {
        if (name->empty() || find_column(points.names, *name)) continue;
        throw InputError(fmt::format("{}: there is no column \"{}\"; the file has: {}", file, quotable(*name),
                                     quotable_list(points.offered)));
    }
    const auto none = [](const std::string&) {};  // those that are chosen are there
    const auto size = find_size(points.names, chosen, none);
    if (size) {
        source.radius = points.arrays[size->index];
        for (double& value : source.radius) value *= size->to_radius;
        source.facts.emplace_back("size from", points.names[size->index]);
    }
    const auto type = find_type(points.names, chosen, none);
    if (type) {
        for (const double value : points.arrays[*type]) source.type.add(shortest(value));
    }
    if (const auto id = find_id(points.names)) {
        if (points.identities.size() == source.position.size()) {
            source.id = std::move(points.identities);
        } else {
            source.warnings.push_back(
                fmt::format("{}: the array \"{}\" holds other than whole numbers of 64 bits, so it is not taken for "
                            "identities",
                            file, quotable(points.names[*id])));
        }
    }
    if (const auto ghosts = find_ghosts(points.names)) {
        std::vector<bool> own(source.position.size());
        for (std::size_t i = 0; i < own.size(); ++i) own[i] = points.arrays[*ghosts][i] == 0;
        keep(source, own);
    }
    return source;
}

}  // namespace recoat
