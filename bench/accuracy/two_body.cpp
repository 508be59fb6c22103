#include <cstdio>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "bench/accuracy/observables.hpp"
#include "common/error.hpp"
#include "solver/scene/read_scene.hpp"

namespace {

using namespace recoat;
using Json = nlohmann::ordered_json;

struct Options {
    std::string scene;
    std::vector<std::string> settings;
    int phases = 8;
    std::vector<double> capture{0, 0};
    double speed = 0.05, longest = 0, ramp = 0, slope = 0;
};

void add_options(CLI::App& app, Options& o) {
    app.add_option("scene", o.scene, "scene file: the model and the step are taken from it")->required();
    app.add_option("--set", o.settings, "a.b=v: overrides");
    app.add_option("--phases", o.phases, "phases of the first step");
    app.add_option("--capture", o.capture, "where to look for the capture velocity of pair and wall [m/s]")
        ->expected(2);
    app.add_option("--speed", o.speed, "of the fast impact and of sliding [m/s]");
    app.add_option("--longest", o.longest, "time of sliding at most [s]; 0: not measured");
    app.add_option("--oblique", o.slope,
                   "velocity along the wall over that towards it: that impact only; 0: not measured");
    app.add_option("--ramp", o.ramp, "time in which the load of the pull-off grows [s]; 0: not measured");
}

/// One number for each phase.
template <class Measure>
Json over_phases(int phases, const Measure& measure) {
    Json values = Json::array();
    for (int k = 0; k < phases; ++k) values.push_back(measure((k + 0.5) / phases));
    return values;
}

Json impacts(const Bodies& bodies, const Options& o, double guess) {
    Json found;
    found["capture"] = over_phases(o.phases, [&](double phase) { return capture_speed(bodies, guess, phase); });
    found["rebound"] = over_phases(o.phases, [&](double phase) { return rebound_speed(bodies, 2 * guess, phase); });
    found["fast"] = over_phases(o.phases, [&](double phase) { return rebound_speed(bodies, o.speed, phase); });
    return found;
}

void measure(const Options& o) {
    const Scene scene = load_scene(o.scene, o.settings);
    const Bodies pair(scene, false), wall(scene, true);
    Json found = {{"time_step", scene.time_step}, {"bond_number", scene.bond_number}};
    if (o.slope > 0) {
        found["oblique"] =
            over_phases(o.phases, [&](double phase) { return oblique_change(wall, o.speed, o.slope, phase); });
        std::puts(found.dump(1).c_str());
        return;
    }
    found["pair"] = impacts(pair, o, o.capture[0]);
    found["wall"] = impacts(wall, o, o.capture[1]);
    if (o.longest > 0) found["stop_distance"] = stop_distance(wall, o.speed, o.longest);
    if (o.ramp > 0) found["pull_off"] = pull_off_load(wall, o.ramp);
    std::puts(found.dump(1).c_str());
}

}  // namespace

/// Capture, rebound, sliding and pull-off of two bodies with the model and step of a scene, as JSON.
int main(int argc, char** argv) {
    return run_program("two-body", [&] {
        Options options;
        CLI::App app("Impacts and sliding of two bodies");
        add_options(app, options);
        CLI11_PARSE(app, argc, argv);
        measure(options);
        return 0;
    });
}
