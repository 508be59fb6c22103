#include "analyzer/output/description.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "common/tables/text_cursor.hpp"

namespace recoat {
namespace {

using Json = nlohmann::ordered_json;

/// Smallest and largest of a value over the particles; null without particles.
template <class Value>
Json extent(const Source& source, Value value) {
    if (source.position.empty()) return nullptr;
    double low = value(0), high = low;
    for (std::size_t i = 1; i < source.position.size(); ++i) {
        low = std::min(low, value(i));
        high = std::max(high, value(i));
    }
    return {low, high};
}

/// Mean of a value over the particles; null without particles.
template <class Value>
Json mean(const Source& source, Value value) {
    if (source.position.empty()) return nullptr;
    double sum = 0;
    for (std::size_t i = 0; i < source.position.size(); ++i) sum += value(i);
    return sum / static_cast<double>(source.position.size());
}

/// The box of the file, its periodic directions marked.
void add_box(Json& json, const Source& source) {
    if (!source.box) return;
    const Vec3 low = source.box->lower, high = source.box->upper;
    json["box x [m]"] = {low.x, high.x};
    json["box y [m]"] = {low.y, high.y};
    json["box z [m]"] = {low.z, high.z};
    std::string periodic;
    for (std::size_t a = 0; a < 3; ++a) periodic += source.box->periodic[a] ? std::string(1, "xyz"[a]) : "";
    json["periodic"] = periodic.empty() ? Json(nullptr) : Json(periodic);
}

/// Names of the types with the number of particles of each, "1 (304), plate (400)"; nothing where there are none.
std::string types_text(const Source& source) {
    constexpr std::size_t most = 12;
    std::vector<std::size_t> counts(source.type.names.size());
    for (const std::uint32_t type : source.type.of) ++counts[type];
    std::string text;
    std::size_t listed = 0;
    for (std::size_t i = 0; i < counts.size(); ++i) {
        if (counts[i] == 0) continue;
        if (++listed > most) return text + ", ...";
        text += fmt::format("{}{} ({})", text.empty() ? "" : ", ", quotable(source.type.names[i]), counts[i]);
    }
    return text;
}

Json known_or_null(double value) { return std::isnan(value) ? Json(nullptr) : Json(value); }

Json description(const Source& source, const std::string& file) {
    const auto& p = source.position;
    Json json = {{"file", file}, {"format", source.format}, {"particles", p.size()}};
    json["x [m]"] = extent(source, [&](std::size_t i) { return p[i].x; });
    json["y [m]"] = extent(source, [&](std::size_t i) { return p[i].y; });
    json["z [m]"] = extent(source, [&](std::size_t i) { return p[i].z; });
    json["mean x [m]"] = mean(source, [&](std::size_t i) { return p[i].x; });
    json["mean y [m]"] = mean(source, [&](std::size_t i) { return p[i].y; });
    json["mean z [m]"] = mean(source, [&](std::size_t i) { return p[i].z; });
    json["radius [m]"] = extent(source, [&](std::size_t i) { return source.radius[i]; });
    if (const std::string types = types_text(source); !types.empty()) json["types"] = types;
    add_box(json, source);
    json["d_p [m]"] = known_or_null(source.info.particle_diameter);
    json["density [kg/m3]"] = known_or_null(source.info.density);
    json["h_b [m]"] = known_or_null(source.info.clearance);
    json["y_min [m]"] = known_or_null(source.info.y_min);
    json["y_period [m]"] = known_or_null(source.info.y_period);
    json["blade_start [m]"] = known_or_null(source.info.blade_start);
    json["spread_length [m]"] = known_or_null(source.info.spread_length);
    json["layer_end [m]"] = known_or_null(source.info.layer_end);
    for (const auto& [name, value] : source.facts) json[name] = value;
    return json;
}

std::string as_text(const Json& value) {
    if (value.is_null()) return "not in the file";
    if (value.is_string()) return value.get<std::string>();
    if (value.is_array()) return fmt::format("{:.9g} ... {:.9g}", value[0].get<double>(), value[1].get<double>());
    if (value.is_number_float()) return fmt::format("{:.9g}", value.get<double>());
    return value.dump();
}

}  // namespace

std::string describe_source(const Source& source, const std::string& file, bool as_json) {
    const Json json = description(source, file);
    if (as_json) return json.dump(1) + "\n";
    std::string text;
    for (const auto& [name, value] : json.items()) text += fmt::format("{:20} {}\n", name, as_text(value));
    return text;
}

}  // namespace recoat
