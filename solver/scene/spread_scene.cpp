#include "solver/scene/spread_scene.hpp"

#include <algorithm>
#include <limits>

#include "common/number.hpp"
#include "solver/scene/read_stages.hpp"

namespace recoat {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

struct Box {
    double length, width, fill_length, behind_blade;
};

struct Blade {
    double thickness, clearance, speed, lift_speed, position, height;
};

Box read_box(const Config& box, double diameter) {
    Box result{};
    result.length = box.quantity_or("length", Dimension::length, 600 * diameter, Range::positive());
    result.width = box.quantity_or("width", Dimension::length, 40 * diameter, Range::positive());
    result.fill_length = box.quantity_or("fill_length", Dimension::length, 40 * diameter, Range::positive());
    result.behind_blade = box.quantity_or("behind_blade", Dimension::length, 5 * diameter, Range::not_negative());
    if (result.width < 4 * diameter) box.fail("width", "the period is too short for the particles; give 4 dp or more");
    if (result.fill_length < 2 * diameter) box.fail("fill_length", "no room for particles; give 2 dp or more");
    return result;
}

Blade read_blade(const Config& blade, double diameter) {
    Blade result{};
    result.thickness = blade.quantity_or("thickness", Dimension::length, 4 * diameter, Range::positive());
    result.clearance = blade.quantity("clearance", Dimension::length, Range::positive());
    result.speed = blade.quantity("speed", Dimension::speed, Range::positive());
    result.lift_speed = blade.quantity_or("lift_speed", Dimension::speed, result.speed, Range::positive());
    result.position = blade.quantity_or("position", Dimension::length, 0);
    result.height = blade.quantity_or("height", Dimension::length, 0, Range::not_negative());
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

ParticleSource read_source(const Config& config, const std::filesystem::path& folder, const Scene& scene,
                           double blade_front, double fill_length) {
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
    column.x_lower = blade_front;
    column.x_upper = blade_front + fill_length;
    column.seed = scene.seed;
    return column;
}

void check_room(const Config& config, const Box& box, const Blade& blade, const Scene& scene) {
    const double front = blade.position + blade.thickness + scene.spread->length;
    if (blade.position - box.behind_blade > blade.position) config.fail("box", "behind_blade is negative");
    const double end = box.length - box.behind_blade;
    if (front > end) {
        config.fail("box",
                    "the blade would run into the front end wall: blade thickness and spreading length together are " +
                        shortest(front / scene.diameter) + " dp, the box ends at " + shortest(end / scene.diameter) +
                        " dp; give a longer box.length or a shorter spread");
    }
    if (blade.position + blade.thickness + box.fill_length > end) {
        config.fail("box", "the gate lies beyond the front end wall; give a longer box.length");
    }
}

}  // namespace

void read_spread_scene(const Config& config, const std::filesystem::path& folder, Scene& scene) {
    const double diameter = scene.diameter;
    if (scene.gravity == 0) config.fail("gravity", "spreading needs gravity; give e.g. 9.81 m/s2");
    const Box box = read_box(config.section_or_empty("box"), diameter);
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
    scene.source = read_source(config, folder, scene, blade_front, box.fill_length);
    scene.spread = SpreadGeometry{blade.clearance, blade.position, 0, box.fill_length, blade.speed};
    read_stages(config, blade.height, blade.lift_speed, scene);
    check_room(config, box, blade, scene);
}

}  // namespace recoat
