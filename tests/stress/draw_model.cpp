#include "tests/stress/draw_model.hpp"

#include <algorithm>

#include "common/number.hpp"
#include "solver/scene/model_options.hpp"
#include "solver/scene/time_step_limits.hpp"

namespace recoat::stress {
namespace {

std::string options_of(Draw& draw, const std::string& section) {
    std::string text;
    for (const ModelOption& option : model_options()) {
        if (option.section != section || draw.chance(0.5)) continue;
        text += ", " + std::string(option.key) + ": " + std::string(draw.pick(option.names()));
    }
    return text;
}

std::string draw_material(Draw& draw, ModelDraw& made, Scene& scene) {
    made.diameter = draw.decades(1e-5, 2e-4);
    scene.diameter = made.diameter;
    scene.model.density = draw.decades(800, 9000);
    scene.model.youngs_modulus = draw.decades(1e8, 3e11);
    scene.model.poisson_ratio = draw.chance(0.2) ? draw.pick<double>({0, 0.5}) : draw.between(0.1, 0.45);
    scene.model.stiffness_ratio = draw.chance(0.2) ? 1 : draw.decades(1e-5, 1);
    return "material: {diameter: " + shortest(made.diameter) + " m, density: " + shortest(scene.model.density) +
           " kg/m3, young_modulus: " + shortest(scene.model.youngs_modulus) +
           " Pa, poisson_ratio: " + shortest(scene.model.poisson_ratio) +
           "}\nstiffness_ratio: " + shortest(scene.model.stiffness_ratio) + "\n";
}

std::string draw_contact(Draw& draw) {
    const double restitution = draw.chance(0.2) ? draw.pick<double>({0.01, 1}) : draw.between(0.01, 1);
    const double sliding = draw.chance(0.2) ? draw.pick<double>({0, 2}) : draw.between(0, 1);
    const double rolling = draw.chance(0.3) ? draw.pick<double>({0, 2}) : draw.decades(1e-3, 1);
    const std::string options = options_of(draw, "contact");
    return "contact: {restitution: " + shortest(restitution) + ", sliding_friction: " + shortest(sliding) +
           ", rolling_friction: " + shortest(rolling) + options + "}\n";
}

std::string draw_cohesion(Draw& draw, ModelDraw& made) {
    if (draw.chance(0.25)) return {};
    const double bond = draw.chance(0.1) ? 0 : draw.decades(1e-2, 1e4);
    made.separation = draw.decades(1e-10, 1e-9);
    made.cut_off = draw.decades(1.01 * made.separation, 0.09 * made.diameter);
    return "cohesion: {bond_number: " + shortest(bond) + ", minimum_separation: " + shortest(made.separation) +
           " m, cut_off: " + shortest(made.cut_off) + " m" + options_of(draw, "cohesion") + "}\n";
}

}  // namespace

ModelDraw draw_model(Draw& draw, bool needs_gravity) {
    ModelDraw made;
    Scene scene;
    made.text = draw_material(draw, made, scene);
    made.text += draw_contact(draw);
    made.text += draw_cohesion(draw, made);
    const bool weightless = draw.chance(0.3), earth = draw.chance(0.6);
    const double elsewhere = draw.decades(1, 2000);
    const double gravity = !needs_gravity && weightless ? 0 : (earth ? 9.81 : elsewhere);
    made.gravity = gravity > 0;
    made.speed = draw.decades(1e-3, 5);
    made.smallest = 0.5 * made.diameter / (draw.chance(0.5) ? 1 : draw.decades(1, 10));
    scene.smallest_diameter = 2 * made.smallest;
    scene.reference_speed = made.speed;
    double limit = 1;
    for (const StepLimit& each : time_step_limits(scene)) {
        if (each.stability) limit = std::min(limit, each.limit);
    }
    made.step_share = draw.chance(0.2) ? draw.pick<double>({0.5, 1, 2}) : draw.decades(1e-3, 2);
    // Where a particle would cross a twentieth of a radius in a step the run could not even begin.
    made.time_step = std::min(made.step_share * limit, 0.04 * made.smallest / made.speed);
    made.step_share = made.time_step / limit;
    made.text += "gravity: " + shortest(gravity) + " m/s2\ntime_step: " + shortest(made.time_step) + " s\n";
    return made;
}

}  // namespace recoat::stress
