#include "tests/stress/draw_spread.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "common/number.hpp"
#include "tests/stress/draw_model.hpp"

namespace recoat::stress {
namespace {

constexpr int most_steps = 5000;  ///< of a stage

/// Speed at which `length` takes no more than `most_steps`.
double at_least(double speed, double length, double time_step) {
    return std::max(speed, length / (most_steps * time_step));
}

std::string draw_box(Draw& draw, double fill_length, double spread_length) {
    const double length = 5 + 4 + std::max(fill_length, spread_length) + draw.between(0, 5);
    const bool narrow = draw.chance(0.3);
    const double width = draw.between(4, 8);
    const double behind = draw.pick<double>({0, 5});
    return fmt::format("box: {{length: {} dp, width: {} dp, fill_length: {} dp, behind_blade: {} dp}}\n",
                       shortest(length + 5), shortest(narrow ? 4 : width), shortest(fill_length), behind);
}

std::string draw_blade(Draw& draw, const ModelDraw& model, double length, std::string& character) {
    const double clearance = draw.between(0.3, 3), factor = draw.decades(1, 100);
    const bool fast = draw.chance(0.4);
    if (fast) character += ", fast blade";
    const double d = model.diameter, dt = model.time_step;
    return fmt::format("blade: {{clearance: {} dp, speed: {} m/s, lift_speed: {} m/s}}\n", shortest(clearance),
                       shortest(at_least(model.speed * (fast ? factor : 1), length * d, dt)),
                       shortest(at_least(model.speed, clearance * d, dt)));
}

/// Sizes down to those of the smallest particles of the model, for half of the scenes that have such.
std::string draw_sizes(Draw& draw, const ModelDraw& model, std::string& character) {
    const double largest = model.diameter, smallest = 2 * model.smallest, middle = draw.between(smallest, largest);
    const double deviation = draw.decades(1.01, 3);
    const int kind = draw.whole(0, 2);
    const std::string weighting = draw.pick<std::string>({"number", "mass"});
    if (smallest == largest || draw.chance(0.5)) return {};
    character += ", sizes";
    const std::string bounds = fmt::format(", smallest: {} m, largest: {} m", shortest(smallest), shortest(largest));
    std::string numbers;
    if (kind == 0)
        numbers = fmt::format("normal, mean: {} m, standard_deviation: {} m{}", shortest(middle),
                              shortest(middle * (deviation - 1)), bounds);
    else if (kind == 1)
        numbers = fmt::format("log_normal, median: {} m, geometric_deviation: {}{}", shortest(middle),
                              shortest(deviation), bounds);
    else
        numbers = fmt::format("table, diameters: [{} m, {} m, {} m], cumulative: [0, 0.5, 1]", shortest(smallest),
                              shortest(middle), shortest(largest));
    return fmt::format(", sizes: {{distribution: {}, weighting: {}}}", numbers, weighting);
}

std::string draw_time(Draw& draw, double time_step) {
    return "settle_time: " + shortest(draw.whole(1, most_steps) * time_step) + " s";
}

}  // namespace

Case draw_spread_case(Draw& draw) {
    const ModelDraw model = draw_model(draw, true);
    Case result;
    result.character = "spread";
    result.step_share = model.step_share;
    const double length = draw.decades(0.5, 10), roomy = draw.between(2, 6);
    const double fill_length = draw.chance(0.2) ? 2 : roomy;
    const int seed = draw.whole(0, 1000000), count = draw.whole(1, 60);
    const bool one = draw.chance(0.1), trajectory = draw.chance(0.2);
    const std::string sizes = draw_sizes(draw, model, result.character);
    std::string text = fmt::format("scene: spread\nseed: {}\n{}powder: {{particles: {}{}}}\n", seed, model.text,
                                   one ? 1 : count, sizes);
    text += draw_box(draw, fill_length, length);
    text += draw_blade(draw, model, length, result.character);
    text += "stages:\n  - fill: {" + draw_time(draw, model.time_step) + "}\n";
    text += "  - heap: {" + draw_time(draw, model.time_step) + "}\n";
    text += "  - spread: {length: " + shortest(length) + " dp, " + draw_time(draw, model.time_step) + "}\n";
    result.scene =
        text + fmt::format("output: {{energy_interval: {} s, trajectory_interval: {} s}}\n",
                           shortest(500 * model.time_step), trajectory ? shortest(2000 * model.time_step) : "0");
    return result;
}

}  // namespace recoat::stress
