#include "bench/accuracy/held_pairs.hpp"

#include <cstdio>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "common/error.hpp"
#include "solver/scene/initial_particles.hpp"
#include "solver/scene/read_scene.hpp"

/// Counts the pairs of a scene of particles whose attraction was taken for constant, and those that left their overlap
/// all the same; with what the attraction was not charged for, as JSON.
int main(int argc, char** argv) {
    return recoat::run_program("held-pairs", [&] {
        using namespace recoat;
        std::string path;
        std::vector<std::string> settings;
        std::int64_t warm = 0, steps = 1000;
        CLI::App app("Pairs that were taken to stay in their overlap, and those that did not");
        app.add_option("scene", path, "scene of particles")->required();
        app.add_option("--set", settings, "a.b=v: overrides");
        app.add_option("--warm", warm, "steps before those that are looked at");
        app.add_option("--steps", steps, "steps looked at");
        CLI11_PARSE(app, argc, argv);
        const Scene scene = load_scene(path, settings);
        const EngineSetup setup = engine_setup(scene, Resources{.backend = Backend::cpu, .threads = 1});
        const auto engine = make_engine(setup, initial_particles(scene), scene.walls);
        engine->advance(warm);
        const EnergyLedger before = engine->ledger();
        HeldPairs found;
        HeldPairsOfStep step(*engine, setup);
        for (std::int64_t k = 0; k < steps; ++k) found.add(step());
        const EnergyLedger after = engine->ledger();
        std::printf(
            "{\"particles\": %zu, \"bond_number\": %g, \"time_step\": %g, \"steps\": %lld, \"held\": %lld, \"left\": "
            "%lld, \"furthest\": %.3g, \"missed\": %.4g, \"dissipated\": %.4g, \"wall_work\": %.4g}\n",
            engine->particles().size(), scene.bond_number, setup.time_step, static_cast<long long>(steps),
            static_cast<long long>(found.held), static_cast<long long>(found.left), found.furthest, found.missed,
            after.dissipated() - before.dissipated(), after.wall_work - before.wall_work);
        return 0;
    });
}
