#include "solver/scene/spread_scene.hpp"

#include <algorithm>
#include <limits>

#include <fmt/format.h>

#include "common/number.hpp"
#include "common/readable.hpp"
#include "solver/scene/read_sizes.hpp"
#include "solver/scene/read_stages.hpp"
#include "solver/scene/read_time_step.hpp"

namespace recoat {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

struct Box {
    double length, width, fill_length, behind_blade;
};

struct Blade {
    double thickness, clearance, speed, lift_speed, position, height;
};

/// `largest`: diameter of the largest particles [m].
Box read_box(const Config& box, double diameter, double largest) {
    Box result{};
    result.length = box.quantity_or("length", Dimension::length, 600 * diameter, Range::positive());
    result.width = box.quantity_or("width", Dimension::length, 40 * diameter, Range::positive());
    result.fill_length = box.quantity_or("fill_length", Dimension::length, 40 * diameter, Range::positive());
    result.behind_blade = box.quantity_or("behind_blade", Dimension::length, 5 * diameter, Range::not_negative());
    box.finish();  // a misspelt key before what follows from its absence
    const auto least = [&](double diameters) {
        return fmt::format("the largest particles, which measure {}; give {} dp or more", readable(largest, "m"),
                           shortest(diameters * largest / diameter));
    };
    if (result.width < 4 * largest) box.fail("width", "the period is too short for " + least(4));
    if (result.fill_length < 2 * largest) box.fail("fill_length", "no room for " + least(2));
    return result;
}

Blade read_blade(const Config& blade, double diameter) {
    Blade result{};
    result.thickness = blade.quantity_or("thickness", Dimension::length, 4 * diameter, Range::positive());
    result.clearance = blade.quantity("clearance", Dimension::length);
    result.speed = blade.quantity("speed", Dimension::speed, Range::positive());
    result.lift_speed = blade.quantity_or("lift_speed", Dimension::speed, result.speed, Range::positive());
    result.position = blade.quantity_or("position", Dimension::length, 0);
    result.height = blade.quantity_or("height", Dimension::length, 0, Range::not_negative());
    blade.finish();
    if (!(result.clearance > 0)) {
        blade.fail("clearance",
                   fmt::format("no particle can pass under a blade with a clearance of {}; give more than the "
                               "diameter of the largest, e.g. 1.5 dp",
                               readable(result.clearance, "m")));
    }
    return result;
}

Wall plane(const std::string& name, Vec3 point, Vec3 normal) {
    Wall wall;
    wall.name = name;
    wall.kind = WallKind::plane;
    wall.point = point;
    wall.normal = normal;
    return wall;
}

Wall blade_wall(const Blade& blade) {
    Wall wall;
    wall.name = "blade";
    wall.kind = WallKind::box;
    wall.lower = {blade.position, -infinity, blade.height};
    wall.upper = {blade.position + blade.thickness, infinity, infinity};
    return wall;
}

/// Something in the list of stages needs or takes away the gate.
bool wants_gate(const Config& config) {
    for (const Config& item : config.list("stages")) {
        if (item.has("fill") || item.has("heap")) return true;
        if (item.has("remove") && item.section("remove").text_or("wall", "") == "gate") return true;
    }
    return false;
}

/// The sizes of the powder, where they are given; sets the bounds of the scene.
std::optional<SizeDistribution> read_powder_sizes(const Config& powder, Scene& scene) {
    if (!powder.has("sizes")) return {};
    const Config section = powder.section("sizes");
    SizeDistribution sizes = read_sizes(section);
    section.finish();
    scene.smallest_diameter = sizes.smallest();
    scene.largest_diameter = sizes.largest();
    if (scene.model.hamaker > 0 && scene.model.cut_off > 0.1 * sizes.smallest())
        section.fail("",
                     "cohesion.cut_off reaches further than a tenth of the smallest diameter; give a shorter cut_off");
    return sizes;
}

ParticleSource read_source(const Config& config, const std::filesystem::path& folder, Scene& scene) {
    if (config.has("start_from")) {
        if (config.has("powder")) {
            config.fail("powder", "the particles come from start_from already; remove one of the two");
        }
        return StateSource{folder / config.text("start_from")};
    }
    const Config powder = config.section("powder");
    ColumnSource column;
    column.count = powder.integer("particles", {.lower = 1, .upper = 1e9});
    column.packing_density = powder.number_or("packing_density", 0.3, {.lower = 0, .upper = 0.35, .lower_open = true});
    column.seed = scene.seed;
    column.sizes = read_powder_sizes(powder, scene);
    return column;
}

void check_room(const Config& config, const Box& box, const Blade& blade, const Scene& scene) {
    const double end = box.length - box.behind_blade;
    if (blade.position < -box.behind_blade)
        config.section("blade").fail("position",
                                     "the blade stands behind the rear end wall; give a longer box.behind_blade");
    if (blade.position + blade.thickness > end)
        config.fail("box", "the blade stands in or beyond the front end wall; give a longer box.length");
    const bool with_gate = std::ranges::find(scene.walls, "gate", &Wall::name) != scene.walls.end();
    if (with_gate && blade.position + blade.thickness + box.fill_length > end)
        config.fail("box", "the gate lies beyond the front end wall; give a longer box.length");
}

}  // namespace

void read_spread_scene(const Config& config, const std::filesystem::path& folder, Scene& scene) {
    const double diameter = scene.diameter;
    if (scene.gravity == 0) config.fail("gravity", "spreading needs gravity; give e.g. 9.81 m/s2");
    scene.source = read_source(config, folder, scene);
    const Box box = read_box(config.section_or_empty("box"), diameter, scene.largest_diameter);
    const Blade blade = read_blade(config.section("blade"), diameter);
    const double rear = -box.behind_blade;
    const double front = box.length - box.behind_blade;
    const double blade_front = blade.position + blade.thickness;

    scene.y_period = box.width;
    scene.domain_lower = {rear, -infinity, -0.5 * diameter};
    scene.domain_upper = {front, infinity, infinity};
    scene.reference_speed = blade.speed;
    scene.walls = {plane("base", {0, 0, 0}, {0, 0, 1}), plane("rear", {rear, 0, 0}, {1, 0, 0}),
                   plane("front", {front, 0, 0}, {-1, 0, 0}), blade_wall(blade)};
    if (wants_gate(config)) scene.walls.push_back(plane("gate", {blade_front + box.fill_length, 0, 0}, {-1, 0, 0}));
    if (auto* column = std::get_if<ColumnSource>(&scene.source)) {
        column->x_lower = blade_front;
        column->x_upper = blade_front + box.fill_length;
    }
    scene.spread = SpreadGeometry{blade.clearance, blade.position, 0, box.fill_length, blade.speed};
    read_time_step(config, scene);
    check_room(config, box, blade, scene);
    read_stages(config, blade.lift_speed, scene);
}

}  // namespace recoat
