#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <map>
#include <memory>
#include <random>
#include <sstream>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>
#include <time.h>

#include "common/error.hpp"
#include "common/fingerprint.hpp"
#include "common/number.hpp"
#include "solver/engine/engine.hpp"
#include "solver/scene/initial_particles.hpp"
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

/// Gives every particle a velocity of its own, of `speed` [m/s] in a direction that depends on its number only, and a
/// shear along y with that speed at the top.
void set_in_motion(ParticleTable& table, double speed) {
    double top = 0;
    for (const Vec3& x : table.position) top = std::max(top, x.z);
    std::mt19937_64 random(1);
    const auto one = [&] { return 2 * static_cast<double>(random() >> 11) / 9007199254740992.0 - 1; };
    for (std::size_t i = 0; i < table.size(); ++i) {
        Vec3 way = {one(), one(), one()};
        while (squared_norm(way) > 1 || squared_norm(way) < 0.01) way = {one(), one(), one()};
        table.velocity[i] += speed * ((1 / norm(way)) * way + Vec3{0, table.position[i].z / top, 0});
    }
}

/// Of all bits of positions, velocities and spins, in order of identity.
std::uint64_t state_hash(const ParticleTable& table) {
    Fingerprint hash;
    for (const auto* rows : {&table.position, &table.velocity, &table.angular_velocity})
        hash.add(reinterpret_cast<const char*>(rows->data()), rows->size() * sizeof(Vec3));
    return hash.value();
}

double coordination_number(const Engine& engine, std::size_t particles) {
    double touching = 0;
    for (const ContactState& contact : engine.contacts())
        touching += contact.separation < 0 && contact.second >= 0 ? 2 : 0;
    return touching / static_cast<double>(particles);
}

/// Seconds by the clock, and processor seconds of all threads.
struct Seconds {
    double wall = 0, processor = 0;
};

Seconds now() {
    timespec used{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &used);
    const auto wall = std::chrono::steady_clock::now().time_since_epoch();
    return {std::chrono::duration<double>(wall).count(),
            static_cast<double>(used.tv_sec) + 1e-9 * static_cast<double>(used.tv_nsec)};
}

/// What is timed, and what callgrind counts (bench/speed/counts.py names this function): nothing but steps.
[[gnu::noinline]] void timed_steps(Engine& engine, std::int64_t steps) { engine.advance(steps); }

struct Options {
    std::string path, scene = "config/scene.yaml";
    std::vector<std::string> settings;
    double bond = 0, length = 1e-3, width = 1e-3, moving = 0;
    std::int64_t warm = 500, steps = 2000, tiles = 1;
    Resources resources;
};

void add_options(CLI::App& app, Options& o) {
    static const std::map<std::string, Backend> backends = {{"cpu", Backend::cpu}, {"cuda", Backend::cuda}};
    app.add_option("bed", o.path,
                   "CSV file: x,y,z,radius[,vx,vy,vz], SI units; a bed between end walls on a base, "
                   "in place of the particles and walls of the scene");
    app.add_option("--bond", o.bond, "Bond number");
    app.add_option("--length", o.length, "distance of the end walls of the bed [m]");
    app.add_option("--width", o.width, "period of the bed in y [m]");
    app.add_option("--scene", o.scene, "scene file: the model and the step are taken from it");
    app.add_option("--set", o.settings, "a.b=v: overrides");
    app.add_option("--moving", o.moving, "speed at random and of a shear [m/s]: lists change as in a moving heap");
    app.add_option("--warm", o.warm, "steps before the clock starts");
    app.add_option("--steps", o.steps, "steps timed");
    app.add_option("--tiles", o.tiles, "beds side by side along y")->needs("bed");
    app.add_option("--threads", o.resources.threads, "threads");
    app.add_option("--backend", o.resources.backend, "cpu or cuda")->transform(CLI::CheckedTransformer(backends));
    app.add_option("--device", o.resources.device, "number of the CUDA device");
}

/// What is stepped.
struct Start {
    EngineSetup setup;
    ParticleTable particles;
    std::vector<Wall> walls;
};

Start bed_start(const Options& o, Start start) {
    start.setup.y_period = o.width * static_cast<double>(o.tiles);
    start.setup.domain_lower = {-1, -1, -1};
    start.setup.domain_upper = {1, 1, 1};
    start.particles = tiled(read_bed(o.path), o.tiles, o.width);
    const auto plane = [](const char* name, Vec3 point, Vec3 normal) {
        return Wall{name, WallKind::plane, point, normal, {}, {}, {}, true};
    };
    start.walls = {plane("base", {}, {0, 0, 1}), plane("left", {}, {1, 0, 0}),
                   plane("right", {o.length, 0, 0}, {-1, 0, 0})};
    return start;
}

Start start_of(const Options& o) {
    std::vector<std::string> settings = o.settings;
    settings.push_back("cohesion.bond_number=" + shortest(o.bond));
    const Scene scene = load_scene(o.scene, settings);
    const EngineSetup setup = engine_setup(scene, o.resources);
    if (!o.path.empty()) return bed_start(o, {setup, {}, {}});
    return {setup, initial_particles(scene), scene.walls};
}

void measure(const Options& o) {
    Start start = start_of(o);
    if (o.moving > 0) set_in_motion(start.particles, o.moving);
    const std::size_t particles = start.particles.size();
    const auto engine = make_engine(start.setup, start.particles, start.walls);
    engine->advance(o.warm);
    const Seconds before = now();
    timed_steps(*engine, o.steps);
    const Seconds after = now();
    const double wall = after.wall - before.wall;
    // Looking at every contact of a large bed would take longer than the steps.
    const double coordination = particles <= 1'000'000 ? coordination_number(*engine, particles) : NAN;
    std::printf(
        "{\"particles\": %zu, \"bond_number\": %g, \"backend\": \"%s\", \"threads\": %d, \"steps\": %lld, "
        "\"time_step\": %g, \"seconds\": %.4f, \"processor_seconds\": %.4f, \"particle_steps_per_second\": %.4g, "
        "\"coordination_number\": %s, \"kinetic_energy\": %.4g, \"moving\": %g, \"state_hash\": \"%016llx\"}\n",
        particles, o.bond, name_of(o.resources.backend).c_str(), o.resources.threads, static_cast<long long>(o.steps),
        start.setup.time_step, wall, after.processor - before.processor,
        static_cast<double>(particles) * static_cast<double>(o.steps) / wall,
        (std::isnan(coordination) ? "null" : std::to_string(coordination)).c_str(), engine->kinetic_energy(), o.moving,
        static_cast<unsigned long long>(state_hash(engine->particles())));
}

}  // namespace

/// Particle-steps per second of a scene of particles, or of a settled bed between two end walls on a base, periodic in
/// y; the first steps are not timed.
int main(int argc, char** argv) {
    return run_program("step-rate", [&] {
        Options options;
        CLI::App app("Particle-steps per second of a scene of particles, or of a bed");
        add_options(app, options);
        CLI11_PARSE(app, argc, argv);
        measure(options);
        return 0;
    });
}
