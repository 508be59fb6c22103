#include <chrono>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <map>
#include <memory>
#include <sstream>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "common/error.hpp"
#include "common/number.hpp"
#include "solver/engine/engine.hpp"
#include "solver/scene/read_scene.hpp"

namespace {

using namespace recoat;

/// Columns x,y,z,radius[,vx,vy,vz] of a CSV file with one header line; SI units.
ParticleTable read_bed(const std::string& path) {
    std::ifstream file(path);
    if (!file) throw InputError(path + ": cannot be opened; give a CSV file with columns x,y,z,radius[,vx,vy,vz]");
    ParticleTable table;
    std::string line;
    std::getline(file, line);
    while (std::getline(file, line)) {
        std::istringstream fields(line);
        std::string field;
        double v[7] = {0, 0, 0, 0, 0, 0, 0};
        for (int k = 0; k < 7 && std::getline(fields, field, ','); ++k) v[k] = std::stod(field);
        table.position.push_back({v[0], v[1], v[2]});
        table.radius.push_back(v[3]);
        table.velocity.push_back({v[4], v[5], v[6]});
        table.angular_velocity.push_back({});
    }
    return table;
}

/// The bed `tiles` times side by side along y, where it is periodic with `width`.
ParticleTable tiled(const ParticleTable& bed, std::int64_t tiles, double width) {
    ParticleTable table;
    for (std::int64_t t = 0; t < tiles; ++t) {
        for (std::size_t i = 0; i < bed.size(); ++i) {
            const Vec3 x = bed.position[i];
            table.position.push_back({x.x, x.y + static_cast<double>(t) * width, x.z});
            table.velocity.push_back(bed.velocity[i]);
            table.angular_velocity.push_back({});
            table.radius.push_back(bed.radius[i]);
        }
    }
    return table;
}

double coordination_number(const Engine& engine, std::size_t particles) {
    double touching = 0;
    for (const ContactState& contact : engine.contacts())
        touching += contact.separation < 0 && contact.second >= 0 ? 2 : 0;
    return touching / static_cast<double>(particles);
}

double seconds() { return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count(); }

struct Options {
    std::string path, scene = "config/scene.yaml";
    std::vector<std::string> settings;
    double bond = 0, length = 1e-3, width = 1e-3;
    std::int64_t warm = 500, steps = 2000, tiles = 1;
    Resources resources;
};

void add_options(CLI::App& app, Options& o) {
    static const std::map<std::string, Backend> backends = {{"cpu", Backend::cpu}, {"cuda", Backend::cuda}};
    app.add_option("bed", o.path, "CSV file: x,y,z,radius[,vx,vy,vz], SI units")->required();
    app.add_option("--bond", o.bond, "Bond number");
    app.add_option("--length", o.length, "distance of the end walls [m]");
    app.add_option("--width", o.width, "period in y [m]");
    app.add_option("--scene", o.scene, "scene file: the model and the step are taken from it");
    app.add_option("--set", o.settings, "a.b=v: overrides");
    app.add_option("--warm", o.warm, "steps before the clock starts");
    app.add_option("--steps", o.steps, "steps timed");
    app.add_option("--tiles", o.tiles, "beds side by side along y");
    app.add_option("--threads", o.resources.threads, "threads");
    app.add_option("--backend", o.resources.backend, "cpu or cuda")->transform(CLI::CheckedTransformer(backends));
    app.add_option("--device", o.resources.device, "number of the CUDA device");
}

std::unique_ptr<Engine> engine_for(const Options& o, const ParticleTable& bed) {
    std::vector<std::string> settings = o.settings;
    settings.push_back("cohesion.bond_number=" + shortest(o.bond));
    EngineSetup setup = engine_setup(load_scene(o.scene, settings), o.resources);
    setup.y_period = o.width * static_cast<double>(o.tiles);
    setup.domain_lower = {-1, -1, -1};
    setup.domain_upper = {1, 1, 1};
    const auto plane = [](const char* name, Vec3 point, Vec3 normal) {
        return Wall{name, WallKind::plane, point, normal, {}, {}, {}, true};
    };
    return make_engine(
        setup, bed,
        {plane("base", {}, {0, 0, 1}), plane("left", {}, {1, 0, 0}), plane("right", {o.length, 0, 0}, {-1, 0, 0})});
}

void measure(const Options& o) {
    const ParticleTable bed = tiled(read_bed(o.path), o.tiles, o.width);
    const auto engine = engine_for(o, bed);
    engine->advance(o.warm);
    const double start = seconds();
    engine->advance(o.steps);
    const double wall = seconds() - start;
    // Looking at every contact of a large bed would take longer than the steps.
    const double coordination = bed.size() <= 1'000'000 ? coordination_number(*engine, bed.size()) : NAN;
    std::printf(
        "{\"particles\": %zu, \"bond_number\": %g, \"backend\": \"%s\", \"threads\": %d, \"steps\": %lld, "
        "\"seconds\": %.4f, \"particle_steps_per_second\": %.4g, \"coordination_number\": %s, "
        "\"kinetic_energy\": %.4g}\n",
        bed.size(), o.bond, name_of(o.resources.backend).c_str(), o.resources.threads, static_cast<long long>(o.steps),
        wall, static_cast<double>(bed.size()) * static_cast<double>(o.steps) / wall,
        (std::isnan(coordination) ? "null" : std::to_string(coordination)).c_str(), engine->kinetic_energy());
}

}  // namespace

/// Particle-steps per second on a settled bed between two end walls on a base, periodic in y; the first steps are
/// not timed.
int main(int argc, char** argv) {
    return run_program("step-rate", [&] {
        Options options;
        CLI::App app("Particle-steps per second on a settled bed");
        add_options(app, options);
        CLI11_PARSE(app, argc, argv);
        measure(options);
        return 0;
    });
}
