#include "solver/scene/particle_scene.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <set>

#include "solver/scene/join_boxes.hpp"
#include "solver/scene/read_stages.hpp"
#include "solver/scene/read_time_step.hpp"

namespace recoat {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

Wall read_plane(const Config& plane) {
    Wall wall;
    wall.kind = WallKind::plane;
    wall.name = plane.text("name");
    wall.point = plane.vector_or("point", Dimension::length, {});
    wall.normal = plane.vector("normal", Dimension::none);
    const double length = norm(wall.normal);
    if (length == 0) plane.fail("normal", "the normal is zero; give a vector into the free side, e.g. [0, 0, 1]");
    wall.normal = (1 / length) * wall.normal;
    wall.velocity = plane.vector_or("velocity", Dimension::speed, {});
    plane.finish();  // a misspelt key before what follows from its absence
    return wall;
}

Wall read_box_wall(const Config& box) {
    Wall wall;
    wall.kind = WallKind::box;
    wall.name = box.text("name");
    wall.lower = box.vector("lower", Dimension::length, true);
    wall.upper = box.vector("upper", Dimension::length, true);
    if (!(wall.lower.x < wall.upper.x && wall.lower.y < wall.upper.y && wall.lower.z < wall.upper.z)) {
        box.fail("upper", "the box is empty; every component of upper must exceed that of lower");
    }
    wall.velocity = box.vector_or("velocity", Dimension::speed, {});
    box.finish();
    return wall;
}

std::vector<Wall> read_walls(const Config& config) {
    std::vector<Wall> walls;
    std::set<std::string> names;
    if (!config.has("walls")) return walls;
    for (const Config& item : config.list("walls")) {
        const bool is_plane = item.has("plane");
        if (is_plane == item.has("box"))
            item.fail("", "a wall is either a plane or a box; write - plane: {...} or - box: {...}");
        const Config section = item.section(is_plane ? "plane" : "box");
        walls.push_back(is_plane ? read_plane(section) : read_box_wall(section));
        if (!names.insert(walls.back().name).second) {
            section.fail("name", "two walls are called \"" + walls.back().name + "\"; give each its own name");
        }
    }
    return walls;
}

ParticleSource read_source(const Config& config, const std::filesystem::path& folder) {
    if (config.has("start_from") == config.has("particles")) {
        config.fail("",
                    "the particles come from one place; give either particles: TABLE.csv or start_from: STATE.vtkhdf");
    }
    if (config.has("start_from")) return StateSource{folder / config.text("start_from")};
    return TableSource{folder / config.text("particles")};
}

}  // namespace

void read_particle_scene(const Config& config, const std::filesystem::path& folder, Scene& scene) {
    scene.y_period = config.quantity_or("y_period", Dimension::length, 0, Range::not_negative());
    if (scene.y_period > 0 && scene.y_period < 4 * scene.diameter) {
        config.fail("y_period", "the period is too short for the particles; give 4 dp or more, or leave it out");
    }
    scene.domain_lower = {-infinity, -infinity, -infinity};
    scene.domain_upper = {infinity, infinity, infinity};
    scene.source = read_source(config, folder);
    scene.walls = read_walls(config);
    double fastest = 0;
    for (const Wall& wall : scene.walls) fastest = std::max(fastest, norm(wall.velocity));
    scene.reference_speed =
        config.quantity_or("reference_speed", Dimension::speed, fastest > 0 ? fastest : 0.05, Range::positive());
    if (config.has("stages") == config.has("duration")) {
        config.fail("", "the end of the run is not stated, or twice; give either duration or stages");
    }
    read_time_step(config, scene);
    read_stages(config, 0, scene);
    scene.walls = join_boxes(std::move(scene.walls), scene.stages);
}

}  // namespace recoat
