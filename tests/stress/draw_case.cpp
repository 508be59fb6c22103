#include <fmt/format.h>

#include "common/number.hpp"
#include "common/output_file.hpp"
#include "common/state.hpp"
#include "tests/stress/case.hpp"
#include "tests/stress/draw_particles.hpp"
#include "tests/stress/draw_spread.hpp"

namespace recoat::stress {
namespace {

std::string metres(Vec3 v) { return fmt::format("[{} m, {} m, {} m]", shortest(v.x), shortest(v.y), shortest(v.z)); }

std::string speeds(Vec3 v) {
    return fmt::format("[{} m/s, {} m/s, {} m/s]", shortest(v.x), shortest(v.y), shortest(v.z));
}

std::string plane(const std::string& name, Vec3 point, const std::string& normal, Vec3 velocity = {}) {
    return "  - plane: {name: " + name + ", point: " + metres(point) + ", normal: " + normal +
           ", velocity: " + speeds(velocity) + "}\n";
}

/// Walls around the particles, a floor, or none; sometimes one that moves, up to 100 times faster than the particles.
std::string draw_walls(Draw& draw, const ModelDraw& model, const ParticleDraw& made, bool periodic,
                       std::string& character) {
    const Vec3 size = made.size;
    const bool edges = made.character.starts_with("edges");
    std::string text = "walls:\n";
    if (edges)
        text += "  - box: {name: block, lower: " + metres(0.25 * size) +
                ", upper: " + metres({0.75 * size.x, 0.75 * size.y, 0.5 * size.z}) + "}\n";
    const bool floor = model.gravity || draw.chance(0.7), all = draw.chance(0.7);
    if (floor) text += plane("floor", {}, "[0, 0, 1]");
    if (all) {
        text += plane("left", {}, "[1, 0, 0]") + plane("right", size, "[-1, 0, 0]");
        if (!periodic) text += plane("front", {}, "[0, 1, 0]") + plane("back", size, "[0, -1, 0]");
    }
    if (draw.chance(0.3)) {
        const bool fast = draw.chance(0.5);
        const double speed = model.speed * (fast ? draw.decades(1, 100) : draw.decades(0.01, 1));
        if (fast) character += ", fast wall";
        text += plane("lid", size, draw.pick<std::string>({"[0, 0, -1]", "[0.1, 0, -1]"}), {0, 0.3 * speed, -speed});
    }
    return text == "walls:\n" ? "" : text;
}

std::string draw_stages(Draw& draw, const ModelDraw& model, const std::string& walls, int steps) {
    const std::string duration = shortest(steps * model.time_step) + " s";
    const bool floor = walls.find("floor") != std::string::npos;
    if (!floor || draw.chance(0.5)) return "duration: " + duration + "\n";
    const double lift = draw.pick<double>({0, 0.1, -0.1}) * model.speed;
    return "stages:\n  - run: {duration: " + duration +
           "}\n  - move: {wall: floor, velocity: " + speeds({0.1 * model.speed, 0, lift}) + ", duration: " + duration +
           "}\n  - remove: {wall: floor}\n  - settle: {settle_time: " + duration + "}\n";
}

std::string draw_output(Draw& draw, const ModelDraw& model, int steps) {
    const double every = steps / 16 * model.time_step;
    const bool trajectory = draw.chance(0.2), often = draw.chance(0.1);
    return "output: {energy_interval: " + shortest(every) +
           " s, trajectory_interval: " + (trajectory ? shortest(2 * every) : "0") +
           " s, checkpoint_interval: " + (often ? "1e-3" : "600") + " s}\n";
}

/// The check of the step against the limit is for the speed that the scene names: half of the scenes name a lower one.
std::string draw_reference_speed(Draw& draw, const ModelDraw& model) {
    return "reference_speed: " + shortest(model.speed * (draw.chance(0.5) ? 1 : 1e-3)) + " m/s\n";
}

Case draw_particle_case(Draw& draw) {
    const ModelDraw model = draw_model(draw, false);
    const ParticleDraw made = draw_particles(draw, model);
    Case result;
    result.character = made.character;
    result.step_share = model.step_share;
    result.empty_state = made.spheres.empty() && draw.chance(0.5);
    if (!result.empty_state) result.table = made.table();
    const bool periodic = draw.chance(0.3);
    const int steps = draw.whole(100, 5000);
    std::string text = "scene: particles\n" + model.text + draw_reference_speed(draw, model);
    text += result.empty_state ? "start_from: start.vtkhdf\n" : "particles: particles.csv\n";
    if (periodic) {
        const bool narrow = draw.chance(0.5);
        if (narrow) result.character += ", narrow period";
        const double period = narrow ? draw.pick<double>({1, 2, 4, 4.2}) * model.diameter : made.size.y;
        text += "y_period: " + shortest(period) + " m\n";
    }
    const std::string walls = draw_walls(draw, model, made, periodic, result.character);
    text += walls + draw_stages(draw, model, walls, steps);
    result.scene = text + draw_output(draw, model, steps);
    return result;
}

}  // namespace

Case draw_case(std::uint64_t seed, std::uint64_t index) {
    Draw draw(seed, index);
    return draw.chance(0.75) ? draw_particle_case(draw) : draw_spread_case(draw);
}

void write_case(const Case& scene, const std::filesystem::path& folder) {
    write_text_file(folder / "scene.yaml", scene.scene);
    if (scene.empty_state) write_state(folder / "start.vtkhdf", {}, {});
    if (!scene.table.empty()) write_text_file(folder / "particles.csv", scene.table);
}

}  // namespace recoat::stress
