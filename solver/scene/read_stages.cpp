#include "solver/scene/read_stages.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "solver/contact/material.hpp"
#include "solver/scene/wall_course.hpp"
#include "solver/scene/whole_steps.hpp"

namespace recoat {
namespace {

constexpr std::array<std::string_view, 7> kinds = {"fill", "heap", "spread", "move", "remove", "settle", "run"};

/// Turns the items of one list into stages; knows where the walls are before each.
class StageReader {
public:
    StageReader(Scene& scene, double lift_speed) : scene_(scene), lift_speed_(lift_speed), course_(scene) {}

    void add(const Config& item);
    void add_duration(const Config& config) {
        const double duration = config.quantity("duration", Dimension::time, Range::positive());
        scene_.stages.push_back({"run", "run", {Segment{{}, {}, steps(duration), {}}}});
        refuse_impossible(config, "duration");
    }

private:
    std::int64_t steps(double duration) const { return whole_steps(duration, scene_.time_step); }
    void refuse_impossible(const Config& item, std::string_view key);
    void refuse_obstacle(const Config& section) const;
    std::string kind_of(const Config& item) const;
    std::string name_of(const Config& section, const std::string& kind) const;
    std::string wall_of(const Config& section) const;
    Segment settle(const Config& section, double default_energy, double default_time,
                   std::optional<std::int64_t> default_stragglers) const;
    Segment travel(const std::string& wall, Vec3 direction, double distance, double speed) const;
    std::vector<Segment> segments(const std::string& kind, const Config& section);
    std::vector<Segment> fill(const Config& section);
    std::vector<Segment> heap(const Config& section);
    std::vector<Segment> spread(const Config& section);
    std::vector<Segment> move(const Config& section);

    Scene& scene_;
    double lift_speed_;
    WallCourse course_;
};

/// Looks at the last stage.
void StageReader::refuse_impossible(const Config& item, std::string_view key) {
    for (const Segment& segment : scene_.stages.back().segments) {
        if (static_cast<double>(segment.steps) >= most_steps)
            item.fail(key, "this takes 1e15 time steps or more; give a shorter time, a higher speed or a longer step");
        if (const std::string problem = course_.follow(segment); !problem.empty()) item.fail(key, problem);
    }
}

std::string StageReader::kind_of(const Config& item) const {
    const std::vector<std::string> keys = item.keys();
    if (keys.size() == 1 && std::ranges::find(kinds, keys.front()) != kinds.end()) return keys.front();
    std::string known;
    for (std::string_view kind : kinds) known += (known.empty() ? "" : ", ") + std::string(kind);
    item.fail("", "a stage is one of " + known + "; write e.g. - settle: {settle_time: 10 ms}");
}

std::string StageReader::name_of(const Config& section, const std::string& kind) const {
    const auto taken = [&](const std::string& name) {
        return std::ranges::any_of(scene_.stages, [&](const Stage& stage) { return stage.name == name; });
    };
    std::string fallback = kind;
    for (int number = 2; taken(fallback); ++number) fallback = kind + "-" + std::to_string(number);
    std::string name = section.text_or("name", fallback);
    const bool simple =
        std::ranges::all_of(name, [](unsigned char c) { return std::isalnum(c) || c == '-' || c == '_'; });
    if (name.empty() || !simple) {
        section.fail("name", "a stage names a file; use letters, digits, - and _ only");
    }
    if (taken(name) || name == "trajectory" || name == "fault") {
        section.fail("name", "the name \"" + name + "\" is taken; give each stage its own");
    }
    return name;
}

std::string StageReader::wall_of(const Config& section) const {
    std::string name = section.text("wall");
    std::string known;
    for (const Wall& wall : course_.walls()) {
        if (!wall.active) continue;
        if (wall.name == name) return name;
        known += (known.empty() ? "" : ", ") + wall.name;
    }
    section.fail("wall",
                 "there is no wall \"" + name + "\" at this stage; the walls are " + (known.empty() ? "none" : known));
}

/// How many particles may still move at the end of a stage.
std::optional<std::int64_t> stragglers(const Config& section, std::optional<std::int64_t> fallback) {
    constexpr const char* key = "stragglers";
    if (section.has(key) ? section.is_word(key, "auto") : !fallback) {
        (void)section.text_or(key, "auto");
        return {};
    }
    return section.integer_or(key, fallback.value_or(0), {.lower = 0, .upper = 1e9});
}

/// Rest is looked for about every 30th part of the time in which a particle falls its own diameter.
Segment StageReader::settle(const Config& section, double default_energy, double default_time,
                            std::optional<std::int64_t> default_stragglers) const {
    const double mass = sphere_mass(0.5 * scene_.diameter, scene_.model.density);
    const double energy = section.number_or("settle_energy", default_energy, Range::positive());
    const double time = section.quantity_or("settle_time", Dimension::time, default_time, Range::not_negative());
    const double fall = std::sqrt(2 * scene_.diameter / scene_.reference_gravity);
    const RestCriterion rest{energy * mass * scene_.reference_gravity * scene_.diameter,
                             std::max<std::int64_t>(1, steps(fall / 30)), 10, stragglers(section, default_stragglers)};
    return {{}, {}, steps(time), rest};
}

Segment StageReader::travel(const std::string& wall, Vec3 direction, double distance, double speed) const {
    const std::int64_t count = std::max<std::int64_t>(1, steps(distance / speed));
    const double exact = distance / (static_cast<double>(count) * scene_.time_step);
    return {{}, {{wall, exact * direction}}, count, {}};
}

std::vector<Segment> StageReader::fill(const Config& section) {
    if (!scene_.stages.empty()) section.fail("", "fill makes the particles, so it can only be the first stage");
    if (!std::holds_alternative<ColumnSource>(scene_.source)) {
        section.fail("", "the particles come from start_from, so there is nothing to fill; remove this stage");
    }
    return {settle(section, 1e-6, 0.2, 0)};
}

std::vector<Segment> StageReader::heap(const Config& section) {
    Segment segment = settle(section, 1e-4, 0.5, {});
    if (course_.stands("gate")) segment.removed = {"gate"};
    return {segment};
}

/// What stands in the way of a blade that is about to spread.
void StageReader::refuse_obstacle(const Config& section) const {
    if (!course_.stands("blade")) section.fail("", "the blade was taken away by a stage before; leave it there");
    if (course_.stands("gate"))
        section.fail("",
                     "the gate stands in the way of the blade; take it away by a stage before this one, - heap or "
                     "- remove: {wall: gate}");
    const double clearance = scene_.spread->clearance, height = course_.wall("blade").lower.z;
    if (height > clearance * (1 + 1e-9))
        section.fail("",
                     fmt::format("the blade stands {:.4g} dp above the base, higher than blade.clearance ({:.4g} "
                                 "dp), and would not come down; lower it by a stage before, or give blade.clearance "
                                 "that height",
                                 height / scene_.diameter, clearance / scene_.diameter));
}

std::vector<Segment> StageReader::spread(const Config& section) {
    SpreadGeometry& geometry = *scene_.spread;
    const double length = section.quantity_or("length", Dimension::length, 500 * scene_.diameter, Range::positive());
    const Segment rest = settle(section, 1e-4, 0.5, {});
    section.finish();  // a misspelt key first
    refuse_obstacle(section);
    std::vector<Segment> result;
    const double lift = geometry.clearance - course_.wall("blade").lower.z;
    if (lift > 1e-9 * geometry.clearance) result.push_back(travel("blade", {0, 0, 1}, lift, lift_speed_));
    result.push_back(travel("blade", {1, 0, 0}, length, geometry.blade_speed));
    result.push_back(rest);
    geometry.length += length;
    return result;
}

std::vector<Segment> StageReader::move(const Config& section) {
    const std::string wall = wall_of(section);
    const Vec3 velocity = section.vector("velocity", Dimension::speed);
    const double duration = section.quantity("duration", Dimension::time, Range::positive());
    return {Segment{{}, {{wall, velocity}}, steps(duration), {}}};
}

std::vector<Segment> StageReader::segments(const std::string& kind, const Config& section) {
    if (!scene_.spread && (kind == "fill" || kind == "heap" || kind == "spread")) {
        section.fail("", kind + " needs the blade of \"scene: spread\"; use move, remove, settle or run here");
    }
    if (kind == "fill") return fill(section);
    if (kind == "heap") return heap(section);
    if (kind == "spread") return spread(section);
    if (kind == "move") return move(section);
    if (kind == "settle") return {settle(section, 1e-6, 0.1, 0)};
    if (kind == "run")
        return {Segment{{}, {}, steps(section.quantity("duration", Dimension::time, Range::positive())), {}}};
    return {Segment{{wall_of(section)}, {}, 0, {}}};
}

void StageReader::add(const Config& item) {
    const std::string kind = kind_of(item);
    const Config section = item.section(kind);
    const std::string name = name_of(section, kind);
    scene_.stages.push_back({kind, name, segments(kind, section)});
    section.finish();  // a misspelt key before what follows from its absence
    refuse_impossible(item, kind);
}

}  // namespace

void read_stages(const Config& config, double lift_speed, Scene& scene) {
    StageReader reader(scene, lift_speed);
    if (!scene.spread && config.has("duration")) {
        reader.add_duration(config);
        return;
    }
    for (const Config& item : config.list("stages")) reader.add(item);
    if (scene.stages.empty()) config.fail("stages", "the list is empty; give at least one stage");
    const bool makes_particles = std::holds_alternative<ColumnSource>(scene.source);
    if (makes_particles && scene.stages.front().kind != "fill") {
        config.fail("stages", "the first stage does not make the particles; begin with fill, or give start_from");
    }
}

}  // namespace recoat
