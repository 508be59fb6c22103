#include "analyzer/readers/particle_types.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "common/error.hpp"
#include "common/tables/text_cursor.hpp"

namespace recoat {
namespace {

template <class Value>
void keep_those(std::vector<Value>& values, const std::vector<bool>& kept) {
    if (values.empty()) return;
    std::size_t count = 0;
    for (std::size_t i = 0; i < kept.size(); ++i) {
        if (kept[i]) values[count++] = values[i];
    }
    values.resize(count);
}

void require_types(const Source& source, const std::string& file, std::string_view purpose) {
    if (!source.type.of.empty() || source.position.empty()) return;
    throw InputError(
        fmt::format("{}: the file gives no types of its particles under a usual name, which {} needs; name "
                    "the column with --type-column",
                    file, purpose));
}

bool among(const std::vector<std::string>& names, const std::string& name) {
    return std::ranges::find(names, name) != names.end();
}

}  // namespace

void keep(Source& source, const std::vector<bool>& kept) {
    keep_those(source.position, kept);
    keep_those(source.radius, kept);
    keep_those(source.velocity, kept);
    keep_those(source.angular_velocity, kept);
    keep_those(source.id, kept);
    keep_those(source.type.of, kept);
    keep_those(source.line, kept);
}

void ParticleTypes::add(std::string_view name) {
    // Neighbours in a file are mostly of one type.
    if (!of.empty() && names[of.back()] == name) return of.push_back(of.back());
    auto place = static_cast<std::size_t>(std::ranges::find(names, name) - names.begin());
    if (place == names.size()) names.emplace_back(name);
    of.push_back(static_cast<std::uint32_t>(place));
}

std::string list_types(const Source& source) { return quotable_list(source.type.names); }

void choose_types(Source& source, const std::string& file, const ReadOptions& options) {
    if (options.types.empty() && options.types_left_out.empty()) return;
    require_types(source, file, options.types.empty() ? "--without-type" : "--type");
    if (source.position.empty()) return;
    for (const auto* wanted : {&options.types, &options.types_left_out}) {
        for (const std::string& name : *wanted) {
            if (among(source.type.names, name)) continue;
            throw InputError(fmt::format("{}: no particle is of the type \"{}\"; the types are: {}", file,
                                         quotable(name), list_types(source)));
        }
    }
    std::vector<bool> kept(source.position.size());
    for (std::size_t i = 0; i < kept.size(); ++i) {
        const std::string& name = source.type.names[source.type.of[i]];
        kept[i] = (options.types.empty() || among(options.types, name)) && !among(options.types_left_out, name);
    }
    if (std::ranges::find(kept, true) == kept.end()) {
        source.warnings.push_back(
            fmt::format("{}: the choice of types leaves no particle; the types are: {}", file, list_types(source)));
    }
    keep(source, kept);
}

void set_radius_of_types(Source& source, const std::string& file, const ReadOptions& options) {
    require_types(source, file, "a radius of each type");
    std::vector<double> radius;
    for (const std::string& name : source.type.names) {
        const auto found = options.radius_of_type.find(name);
        radius.push_back(found == options.radius_of_type.end() ? 0 : found->second);
    }
    source.radius.clear();
    for (const std::uint32_t type : source.type.of) {
        if (radius[type] == 0) {
            throw InputError(fmt::format("{}: --radius gives no radius for the type \"{}\"; the types are: {}", file,
                                         quotable(source.type.names[type]), list_types(source)));
        }
        source.radius.push_back(radius[type]);
    }
}

void leave_out_size_zero(Source& source, const std::string& file) {
    std::vector<bool> kept(source.radius.size());
    for (std::size_t i = 0; i < kept.size(); ++i) kept[i] = source.radius[i] != 0;
    const auto count = std::ranges::count(kept, false);
    if (count == 0) return;
    keep(source, kept);
    source.warnings.push_back(
        fmt::format("{}: {} of {} particles are left out, for they have the size 0", file, count, kept.size()));
}

}  // namespace recoat
